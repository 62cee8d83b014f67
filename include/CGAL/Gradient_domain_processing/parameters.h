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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_PARAMETERS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_PARAMETERS_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/version.h>

#include <iterator>
#include <type_traits>
#include <utility>

/// \file parameters.h
/// The named parameters of this package. They chain with those of CGAL in any order.

// The names this package adds to CGAL's. Merged into CGAL, the list moves to parameters_interface.h.
#define CGAL_GDP_OWN_NAMES(ADD)        \
  ADD(value_weight)                    \
  ADD(gradient_weight)                 \
  ADD(gradient_scale)                  \
  ADD(curvature_weight)                \
  ADD(curvature_metric_kind)           \
  ADD(face_metric_map)                 \
  ADD(curvature_estimator)             \
  ADD(jet_degree)                      \
  ADD(presmoothing_weight)             \
  ADD(vertex_curvature_map)            \
  ADD(area_normalization)              \
  ADD(vertex_value_weight_map)         \
  ADD(face_gradient_weight_map)        \
  ADD(face_gradient_scale_map)         \
  ADD(border_condition)                \
  ADD(non_manifold_condition)          \
  ADD(restore_volume)                  \
  ADD(normal_projection_weight)        \
  ADD(sharpening_weight)               \
  ADD(sharpening_scale)                \
  ADD(sharpening_curvature_weight)     \
  ADD(sharpening_metric_kind)          \
  ADD(interior_edge_weight_map)        \
  ADD(normal_fit_kind)                 \
  ADD(weld_tolerance)                  \
  ADD(non_shrinking_order)             \
  ADD(max_displacement)                \
  ADD(movable_axes)                    \
  ADD(missing_values)                  \
  ADD(noise_level)                     \
  ADD(noise_scale)                     \
  ADD(denoising_summary)               \
  ADD(number_of_harmonics)             \
  ADD(spectral_shift)                  \
  ADD(embedding_measure)               \
  ADD(hessian_weight)                  \
  ADD(hessian_kind)

#if CGAL_VERSION_NR < 1060000000
#define CGAL_GDP_NAMES(ADD) CGAL_GDP_OWN_NAMES(ADD) ADD(concurrency_tag)
#else
#define CGAL_GDP_NAMES(ADD) CGAL_GDP_OWN_NAMES(ADD)
#endif

namespace CGAL {

namespace internal_np {
#define CGAL_GDP_TAG(NAME) enum NAME##_t { NAME };
CGAL_GDP_NAMES(CGAL_GDP_TAG)
#undef CGAL_GDP_TAG
} // namespace internal_np

namespace Gradient_domain_processing {
namespace internal {

// Marks a pack that also knows this package's names. CGAL's template is partially specialized on it.
template <class NamedParameters>
struct Pack : NamedParameters
{
  explicit Pack(const NamedParameters& np) : NamedParameters(np) {}
};

typedef Pack<CGAL::parameters::Default_named_parameters> Empty_pack;

} // namespace internal
} // namespace Gradient_domain_processing

#define CGAL_GDP_MEMBER(TAG, NAME)                                                                                    \
  template <class K>                                                                                                  \
  Named_function_parameters<K, internal_np::TAG, Gradient_domain_processing::internal::Pack<self> >                   \
  NAME(const K& k) const                                                                                              \
  {                                                                                                                   \
    typedef Gradient_domain_processing::internal::Pack<self> Base_pack;                                               \
    return Named_function_parameters<K, internal_np::TAG, Base_pack>(k, Base_pack(*this));                            \
  }

// CGAL's names come from CGAL's own list, whichever version that is.
#define CGAL_add_named_parameter_with_compatibility(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_cref_only(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_ref_only(X, Y, Z)
#define CGAL_add_extra_named_parameter_with_compatibility(X, Y, Z)

/// \cond SKIP_IN_MANUAL
template <class T, class Tag, class Base>
struct Named_function_parameters<T, Tag, Gradient_domain_processing::internal::Pack<Base> >
  : internal_np::Named_params_impl<T, Tag, Gradient_domain_processing::internal::Pack<Base> >
{
  typedef internal_np::Named_params_impl<T, Tag, Gradient_domain_processing::internal::Pack<Base> > base;
  typedef Named_function_parameters self;
  typedef int CGAL_Named_function_parameters_class; // by which CGAL 6 recognizes a pack

  Named_function_parameters(const T& value, const Gradient_domain_processing::internal::Pack<Base>& before)
    : base(value, before)
  {
  }

#define CGAL_GDP_OWN_MEMBER(NAME) CGAL_GDP_MEMBER(NAME##_t, NAME)
CGAL_GDP_NAMES(CGAL_GDP_OWN_MEMBER)
#undef CGAL_GDP_OWN_MEMBER

#define CGAL_add_named_parameter(X, Y, Z) CGAL_GDP_MEMBER(X, Z)
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#undef CGAL_add_named_parameter
};
/// \endcond

namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingParameters
 *
 * The functions that start a chain of named parameters: one for each name of this package and one for each of CGAL's.
 * Every chain goes on with any of them, as in
 * `GDP::parameters::gradient_weight(1e-3).vertex_point_map(vpm).gradient_scale(2)`, and may be passed to the functions
 * of other CGAL packages as well, which ignore the names they do not know.
 */
namespace parameters {

#define CGAL_GDP_FUNCTION(TAG, NAME)                                                                                  \
  template <class K>                                                                                                  \
  Named_function_parameters<K, internal_np::TAG, internal::Empty_pack> NAME(const K& k)                               \
  {                                                                                                                   \
    return Named_function_parameters<K, internal_np::TAG, internal::Empty_pack>(                                      \
      k, internal::Empty_pack(CGAL::parameters::default_values()));                                                   \
  }

#define CGAL_GDP_OWN_FUNCTION(NAME) CGAL_GDP_FUNCTION(NAME##_t, NAME)
CGAL_GDP_NAMES(CGAL_GDP_OWN_FUNCTION)
#undef CGAL_GDP_OWN_FUNCTION

#define CGAL_add_named_parameter(X, Y, Z) CGAL_GDP_FUNCTION(X, Z)
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#undef CGAL_add_named_parameter

/*!
 * \ingroup PkgGradientDomainProcessingParameters
 *
 * continues a chain that was begun with CGAL's own functions:
 * `GDP::parameters::with(CGAL::parameters::vertex_point_map(vpm)).gradient_weight(1e-3)`.
 */
template <class T, class Tag, class Base>
auto with(const Named_function_parameters<T, Tag, Base>& np)
{
  typedef internal::Pack<Named_function_parameters<T, Tag, Base> > Base_pack;
  return Named_function_parameters<bool, CGAL::internal_np::all_default_t, Base_pack>(true, Base_pack(np));
}

/*!
 * \ingroup PkgGradientDomainProcessingParameters
 *
 * returns the pack in which every parameter has its default.
 */
inline CGAL::parameters::Default_named_parameters default_values()
{
  return CGAL::parameters::default_values();
}

#undef CGAL_GDP_FUNCTION

} // namespace parameters

namespace internal {

template <class Tag, class NamedParameters>
struct Has_parameter
  : std::integral_constant<bool, !std::is_same<typename CGAL::internal_np::Lookup_named_param_def<
                                                 Tag, NamedParameters, CGAL::internal_np::Param_not_found>::type,
                                               CGAL::internal_np::Param_not_found>::value>
{};

template <class Tag, class NamedParameters, class Default>
using Parameter_type = typename CGAL::internal_np::Lookup_named_param_def<Tag, NamedParameters, Default>::type;

template <class T>
struct Is_pack : std::false_type {};

template <class T, class Tag, class Base>
struct Is_pack<Named_function_parameters<T, Tag, Base> > : std::true_type {};

template <class T, class = void>
struct Is_range : std::false_type {};

template <class T>
struct Is_range<T, decltype(void(std::begin(std::declval<T&>())), void(std::end(std::declval<T&>())))> : std::true_type
{
};

// Tell f(tm, np), f(region, tm, np), f(points, polygons, np) and f(region, points, polygons, np) from each other.
template <class TriangleMesh>
using Enable_if_mesh = typename std::enable_if<!Is_pack<TriangleMesh>::value && !Is_range<TriangleMesh>::value>::type;

template <class PolygonRange>
using Enable_if_range = typename std::enable_if<Is_range<PolygonRange>::value>::type;

/// The value of a parameter, or `fallback`.
template <class NamedParameters, class Tag, class Default>
auto parameter(const NamedParameters& np, Tag tag, const Default& fallback)
{
  if constexpr (Has_parameter<Tag, NamedParameters>::value)
    return CGAL::parameters::get_parameter(np, tag);
  else
    return fallback;
}

} // namespace internal
} // namespace Gradient_domain_processing

#undef CGAL_GDP_MEMBER
#undef CGAL_add_named_parameter_with_compatibility
#undef CGAL_add_named_parameter_with_compatibility_cref_only
#undef CGAL_add_named_parameter_with_compatibility_ref_only
#undef CGAL_add_extra_named_parameter_with_compatibility

} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_PARAMETERS_H
