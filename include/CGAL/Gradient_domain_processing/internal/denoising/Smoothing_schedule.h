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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_SMOOTHING_SCHEDULE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_SMOOTHING_SCHEDULE_H

#include <CGAL/Gradient_domain_processing/internal/denoising/Noise_estimate.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Normal_filter.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/constants.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// How the smoothing of normals goes from pass to pass k: the difference sigma_k = s d^k level that counts as similar
// falls, the weight beta_k = b g^k level times the mean edge length and the square of the scale of the noise grows, for
// what is correlated over so many edges takes the square of it in diffusion. All within bounds.
class Smoothing_schedule
{
  const std::vector<char>& m_is_near_border; // by face
  Noise_estimate m_noise;
  double m_length;
  Normal_smoothing m_inside{}, m_at_border{};

public:
  Smoothing_schedule(const std::vector<char>& is_near_border, const Noise_estimate& noise, double mean_edge_length,
                     double scale)
    : m_is_near_border(is_near_border)
    , m_noise(noise)
    , m_length(mean_edge_length * scale * scale)
  {}

  void begin(int pass)
  {
    using namespace denoising;
    m_inside.similarity = (std::min)(
      similarity_max, (std::max)(similarity_min, similarity * m_noise.level * std::pow(similarity_decay, pass)));
    m_inside.weight =
      m_length * (std::min)(smoothing_max, smoothing * m_noise.level * std::pow(smoothing_growth, pass));
    m_at_border = m_inside;
    // half as much again, for a face at the border has two neighbors instead of three
    if(pass < border_passes)
      m_at_border.weight *= 1.5 * m_noise.border_level * std::pow(border_normal_decay, pass);
  }

  const Normal_smoothing& operator()(int f) const { return m_is_near_border[f] ? m_at_border : m_inside; }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_SMOOTHING_SCHEDULE_H
