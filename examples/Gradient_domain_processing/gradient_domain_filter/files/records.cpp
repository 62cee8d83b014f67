// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Records.h"
#include "Text_scanner.h"
#include "file_blocks.h"

#include <algorithm>
#include <cmath>

namespace {

bool is_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// Numbers of a block of text, which may become longer or shorter.
class Text_replacer
{
  const std::string& m_text;
  std::string m_result;
  std::size_t m_copied; // of the text

public:
  Text_replacer(const std::string& text, std::size_t begin, std::size_t end) : m_text(text), m_copied(begin)
  {
    m_result.reserve((end - begin) + (end - begin) / 2);
  }

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
      // text may hold more than its type
      append_number(m_result, x, fits(x, number.type) ? number.type : Number_type::DOUBLE);
      if(number.is_spelled_real && x == std::floor(x))
        m_result += ".0";
      m_copied = at + word.size();
    }
  }

  std::string finish(std::size_t end)
  {
    m_result.append(m_text, m_copied, end - m_copied);
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
  const bool has_lists =
    std::any_of(records.properties.begin(), records.properties.end(), [](const Property& p) { return p.is_list; });
  for_each_block_of_records(records.size(), [&](std::size_t begin, std::size_t end) {
    for(const Replacement& number : replaced.numbers)
    {
      std::size_t distance = 0;
      for(std::size_t i = begin; i < end; ++i)
      {
        if(i == begin || has_lists)
          distance = distance_to(text, records, records.offset(i), number.place);
        char* const at = &text[records.offset(i) + distance];
        const double x = number.value(i);
        if(!is_same(binary_number(at, number.type, records.order), x))
          put_binary_number(at, x, number.type, records.order);
      }
    }
  });
}

// The first record that begins at or after a place of the text.
std::size_t record_at(const Records& records, std::size_t place)
{
  std::size_t low = 0, high = records.size();
  while(low < high)
  {
    const std::size_t middle = low + (high - low) / 2;
    if(records.offset(middle) < place)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

// Records of several kinds may take turns.
std::string replaced_text(const std::string& text, const std::vector<Replaced_records>& replaced, std::size_t begin,
                          std::size_t end)
{
  Text_replacer replacer(text, begin, end);
  std::vector<std::size_t> next, last;
  for(const Replaced_records& r : replaced)
  {
    next.push_back(record_at(*r.records, begin));
    last.push_back(record_at(*r.records, end));
  }
  while(true)
  {
    std::size_t first = replaced.size();
    for(std::size_t k = 0; k < replaced.size(); ++k)
      if(next[k] < last[k]
         && (first == replaced.size()
             || replaced[k].records->offset(next[k]) < replaced[first].records->offset(next[first])))
        first = k;
    if(first == replaced.size())
      return replacer.finish(end);
    replacer.replace(replaced[first], next[first]++);
  }
}

// Where blocks of text begin, and its end: at records, which no other record contains.
std::vector<std::size_t> record_blocks(const std::string& text, const Records& records)
{
  std::vector<std::size_t> begins(1, 0);
  for(std::size_t i = records_of_block; i < records.size(); i += records_of_block)
    begins.push_back(records.offset(i));
  begins.push_back(text.size());
  return begins;
}

} // namespace

void replace_numbers(std::string& text, std::vector<Replaced_records> replaced)
{
  for(Replaced_records& r : replaced)
    std::sort(r.numbers.begin(), r.numbers.end(),
              [](const Replacement& a, const Replacement& b) { return a.place < b.place; });
  if(replaced.empty())
    return;
  if(replaced[0].records->order != Order::ASCII)
  {
    for(const Replaced_records& r : replaced)
      replace_binary(text, r);
    return;
  }

  const auto most =
    std::max_element(replaced.begin(), replaced.end(), [](const Replaced_records& a, const Replaced_records& b) {
      return a.records->size() < b.records->size();
    });
  const std::vector<std::size_t> begins = record_blocks(text, *most->records);
  std::vector<std::string> parts(begins.size() - 1);
  for_each_part(parts.size(),
                [&](std::size_t k) { parts[k] = replaced_text(text, replaced, begins[k], begins[k + 1]); });
  std::size_t size = 0;
  for(const std::string& part : parts)
    size += part.size();
  text.clear();
  text.reserve(size);
  for(const std::string& part : parts)
    text += part;
}
