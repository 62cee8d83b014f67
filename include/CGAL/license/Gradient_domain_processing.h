// Copyright (c) 2026  The Gradient_domain_processing authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Gradient_domain_processing authors
//
// It stands in for the header of this name that CGAL generates from gpl_package_list.txt once the package is part of
// it.

#ifndef CGAL_LICENSE_GRADIENT_DOMAIN_PROCESSING_H
#define CGAL_LICENSE_GRADIENT_DOMAIN_PROCESSING_H

#include <CGAL/config.h>
#include <CGAL/license.h>

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMMERCIAL_LICENSE
#  ifdef CGAL_LICENSE_WARNING
CGAL_pragma_warning("Gradient-Domain Processing is used under the terms of the GPLv3+: "
                    "CGAL_GRADIENT_DOMAIN_PROCESSING_COMMERCIAL_LICENSE is not defined.")
#  endif
#  ifdef CGAL_LICENSE_ERROR
#    error "Gradient-Domain Processing is used under the terms of the GPLv3+, and CGAL_LICENSE_ERROR forbids that."
#  endif
#endif

#endif // CGAL_LICENSE_GRADIENT_DOMAIN_PROCESSING_H
