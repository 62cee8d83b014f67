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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SEPARATE_COMPILATION_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SEPARATE_COMPILATION_H

// What is not a template is defined in X_impl.h beside X.h, which includes it: unless
// CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED is defined. Then a program compiles declarations only, and links with the
// definitions, which are compiled once.
//
// What takes long to compile and few programs use is a template all the same, of `void`: so that without a library it
// is compiled where it is called only.
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#define CGAL_GDP_INLINE
#else
#define CGAL_GDP_INLINE inline
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SEPARATE_COMPILATION_H
