/*!
 * \ingroup PkgGradientDomainProcessingConcepts
 * \cgalConcept
 *
 * A `CurvatureStretch` is a function object that makes a metric of your own from the principal curvatures of a face. It is passed by the
 * named parameter `curvature_metric_kind` (or `sharpening_metric_kind`) in place of a
 * `CGAL::Gradient_domain_processing::Curvature_metric_kind`. A lambda will do:
 *
 * \code
 * // creases with a radius under 2 mm are kept, in a mesh whose unit is the millimeter
 * const auto keep_sharp = [](double k1, double k2) {
 *   const double k = std::max(std::abs(k1), std::abs(k2));
 *   const double s = k > 0.5 ? 1e4 : 1;
 *   return std::make_pair(s, s);
 * };
 * GDP::smooth(mesh, GDP::parameters::curvature_metric_kind(keep_sharp));
 * \endcode
 *
 * The function may be called from several threads at once and must give the same answer for the same curvatures.
 */
class CurvatureStretch
{
public:
  /// returns the stretches \f$ (s_1, s_2) \f$ of squared length along the two principal directions: 1 leaves a direction as it is, more
  /// lets less diffusion pass along it. Both must be positive and finite, else the caller gets `error_invalid_metric`.
  ///
  /// \param k1 the smaller principal curvature, in 1 / unit of length of the mesh, positive where the surface is convex
  /// \param k2 the larger one
  std::pair<double, double> operator()(double k1, double k2) const;
};
