/*!
 * \ingroup PkgGradientDomainProcessingConcepts
 * \cgalConcept
 *
 * A `SignalValue` is the value that a signal has at a vertex: a fixed number of real numbers, its channels. Every channel is filtered
 * for itself, and all are solved together with one factorization.
 *
 * A type is a model if there is a `CGAL::Gradient_domain_processing::Signal_traits` for it, that is: if this compiles for a `value` of
 * the type `T` and an array `channels` of as many `double`s.
 *
 * \code
 * typedef CGAL::Gradient_domain_processing::Signal_traits<T> Traits;
 * const int n = Traits::dimension;                     // the number of channels, at least 1
 * const double c = Traits::channel(value, i);          // the i-th one, 0 <= i < n
 * const T made = Traits::make(channels);               // the value that has these channels
 * \endcode
 *
 * `make()` decides what becomes of results that the type cannot hold. Signals of unit vectors, for example, are not normalized unless
 * their `make()` does so.
 *
 * \cgalHasModelsBegin
 * \cgalHasModelsBare{number types: `double`\, `float`\, integers (rounded and clamped)\, number types of \cgal kernels}
 * \cgalHasModelsBare{`CGAL::Point_2`\, `CGAL::Point_3`\, `CGAL::Vector_2`\, `CGAL::Vector_3`}
 * \cgalHasModelsBare{`CGAL::IO::Color` (four channels from 0 to 255; rounded and clamped)}
 * \cgalHasModelsBare{`std::array` of models}
 * \cgalHasModelsBare{`Eigen::Matrix` of fixed size\, of numbers}
 * \cgalHasModelsEnd
 */
class SignalValue
{
};
