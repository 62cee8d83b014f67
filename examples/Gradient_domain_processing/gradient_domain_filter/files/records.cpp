// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Records.h"
#include "Text_scanner.h"

#include <algorithm>
#include <cmath>

namespace {

bool is_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// Numbers of text, which may become longer or shorter.
class Text_replacer
{
  const std::string& m_text;
  std::string m_result;
  std::size_t m_copied = 0; // of the text

public:
  explicit Text_replacer(const std::string& text) : m_text(text) { m_result.reserve(text.size() + text.size() / 2); }

  void replace(const Replaced_records& replaced, std::size_t i)
  {
    const Records& records = *replaced.records;
    Text_scanner words(m_text.data() + records.offset(i), m_text.data() + m_text.size(), records.lines_continue);
    int place = 0;
    for(const Replacement& number : replaced.numbers)
    {
      for(; place < number.place; ++place)
        skip(words, records, std::size_t(place));
      std::string_view word = words.word();
      word = word.substr(0, word.find_first_of("#\\")); // no number has them: a comment begins or the line goes on
      ++place;
      double before;
      const double value = number.value(i), x = in_range(value, number.type);
      if(Text_scanner::parse(word, before) && (is_same(before, value) || is_same(before, x)))
        continue;
      const std::size_t at = std::size_t(word.data() - m_text.data());
      m_result.append(m_text, m_copied, at - m_copied);
      append_number(m_result, x, fits(x, number.type) ? number.type : Number_type::DOUBLE); // text may hold more than its type
      if(number.is_spelled_real && x == std::floor(x))
        m_result += ".0";
      m_copied = at + word.size();
    }
  }

  std::string finish()
  {
    m_result.append(m_text, m_copied, std::string::npos);
    return std::move(m_result);
  }

private:
  static void skip(Text_scanner& words, const Records& records, std::size_t place)
  {
    double size = 0;
    if(place < records.properties.size() && records.properties[place].is_list)
      words.number(size);
    else
      words.word();
    for(; size >= 1; --size)
      words.word();
  }
};

// How far a place is from the beginning of its record.
std::size_t distance_to(const std::string& text, const Records& records, std::size_t begin, int place)
{
  std::size_t at = begin;
  for(int p = 0; p < place; ++p)
  {
    const Property& property = records.properties[std::size_t(p)];
    if(!property.is_list)
      at += size_of(property.type);
    else
      at += size_of(property.size_type)
            + size_of(property.type) * std::size_t(binary_number(text.data() + at, property.size_type, records.order));
  }
  return at - begin;
}

void replace_binary(std::string& text, const Replaced_records& replaced)
{
  const Records& records = *replaced.records;
  const bool has_lists = std::any_of(records.properties.begin(), records.properties.end(), [](const Property& p) { return p.is_list; });
  for(const Replacement& number : replaced.numbers)
  {
    std::size_t distance = 0;
    for(std::size_t i = 0; i < records.size(); ++i)
    {
      if(i == 0 || has_lists)
        distance = distance_to(text, records, records.offset(i), number.place);
      char* const at = &text[records.offset(i) + distance];
      const double x = number.value(i);
      if(!is_same(binary_number(at, number.type, records.order), x))
        put_binary_number(at, x, number.type, records.order);
    }
  }
}

} // namespace

void replace_numbers(std::string& text, std::vector<Replaced_records> replaced)
{
  for(Replaced_records& r : replaced)
    std::sort(r.numbers.begin(), r.numbers.end(), [](const Replacement& a, const Replacement& b) { return a.place < b.place; });
  if(replaced.empty())
    return;
  if(replaced[0].records->order != Order::ASCII)
  {
    for(const Replaced_records& r : replaced)
      replace_binary(text, r);
    return;
  }

  // records of several kinds may take turns
  Text_replacer replacer(text);
  std::vector<std::size_t> next(replaced.size(), 0);
  while(true)
  {
    std::size_t first = replaced.size();
    for(std::size_t k = 0; k < replaced.size(); ++k)
      if(next[k] < replaced[k].records->size()
         && (first == replaced.size() || replaced[k].records->offset(next[k]) < replaced[first].records->offset(next[first])))
        first = k;
    if(first == replaced.size())
      break;
    replacer.replace(replaced[first], next[first]++);
  }
  text = replacer.finish();
}
