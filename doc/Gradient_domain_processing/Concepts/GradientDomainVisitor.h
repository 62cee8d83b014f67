/*!
 * \ingroup PkgGradientDomainProcessingConcepts
 * \cgalConcept
 *
 * A `GradientDomainVisitor` is told how far a computation is, may stop it, and learns which vertex or face an error is about. It is passed by the named parameter `visitor`: as a
 * value, which is copied, or as a `std::reference_wrapper` (`std::ref(my_visitor)`) if it has a state to read afterwards.
 *
 * Stages may occur more than once, and may nest: curvature is estimated while the metric is prepared, for example. A stage that begins inside
 * of another one ends before it. With several threads `go_on()` may be called from any of them while curvature is estimated, but never by two at once;
 * all else is called from the thread that called the package. Any of these functions may throw; the exception comes through.
 *
 * \cgalHasModelsBegin
 * \cgalHasModels{CGAL::Gradient_domain_processing::Default_visitor}
 * \cgalHasModelsEnd
 */
class GradientDomainVisitor
{
public:
  /// is called when a stage begins.
  void stage_begins(CGAL::Gradient_domain_processing::Stage stage);

  /// is called when a stage ends, also when it ends because of an error or because it was cancelled.
  void stage_ends(CGAL::Gradient_domain_processing::Stage stage);

  /// is called at the beginning of every stage, and regularly within long ones. `part` is the part of the whole work that is done, from 0 to 1, as
  /// estimated from usual durations; it never decreases. Where this returns `false`, the computation stops with `error_cancelled`; mesh and
  /// outputs are as they were.
  bool go_on(double part);

  /// is called before a function returns an error that a vertex is to blame for, with one such vertex:
  /// its point, value, weight, normal or curvature is invalid, or its result is out of range.
  template <class vertex_descriptor>
  void invalid_vertex(CGAL::Gradient_domain_processing::Error_code code, vertex_descriptor v);

  /// is called before a function returns an error that a face is to blame for, with one such face: it is not a triangle, or its
  /// weight, metric, value or target is invalid. A weight of an interior edge counts for one of its faces.
  template <class face_descriptor>
  void invalid_face(CGAL::Gradient_domain_processing::Error_code code, face_descriptor f);

  /// is called, if the visitor has such a member, with a sentence where a user may be surprised: no vertex was moved, vertices were welded or held back.
  void notice(const std::string& sentence);
};
