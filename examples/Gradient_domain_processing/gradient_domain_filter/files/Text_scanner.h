// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_FILES_TEXT_SCANNER_H
#define GRADIENT_DOMAIN_FILTER_FILES_TEXT_SCANNER_H

#include <charconv>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

// Words and numbers of a text in memory. Unlike streams it knows no locale, reads "nan", and is fast.
class Text_scanner
{
  const char* m_at;
  const char* m_end;
  bool m_lines_continue; // after a backslash, as in OBJ

public:
  Text_scanner(const char* begin, const char* end, bool lines_continue = false)
    : m_at(begin), m_end(end), m_lines_continue(lines_continue) {}
  explicit Text_scanner(std::string_view text) : Text_scanner(text.data(), text.data() + text.size()) {}

  const char* position() const { return m_at; }
  std::size_t remaining() const { return std::size_t(m_end - m_at); }
  bool at_end() { skip_space(); return m_at == m_end; }

  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f'; }

  void skip_space()
  {
    while(m_at != m_end && (is_space(*m_at) || is_continuation()))
      ++m_at;
  }

  // The rest of the line, without its end.
  std::string_view line()
  {
    const char* const begin = m_at;
    const char* end = static_cast<const char*>(std::memchr(m_at, '\n', remaining()));
    for(const char* row = begin; m_lines_continue && end && is_continued(row, end);)
    {
      row = end + 1;
      end = static_cast<const char*>(std::memchr(row, '\n', std::size_t(m_end - row)));
    }
    m_at = end ? end + 1 : m_end;
    if(!end)
      end = m_end;
    if(end != begin && end[-1] == '\r')
      --end;
    return std::string_view(begin, std::size_t(end - begin));
  }

  // The next line that says something, without its comment.
  std::string_view line_without_comment()
  {
    while(m_at != m_end)
    {
      std::string_view text = line();
      text = text.substr(0, text.find('#'));
      Text_scanner words(text);
      if(!words.at_end())
        return text;
    }
    return std::string_view();
  }

  // Empty at the end.
  std::string_view word()
  {
    skip_space();
    const char* const begin = m_at;
    while(m_at != m_end && !is_space(*m_at) && !is_continuation())
      ++m_at;
    return std::string_view(begin, std::size_t(m_at - begin));
  }

  bool number(double& x)
  {
    const std::string_view text = word();
    return parse(text, x);
  }

  template <class Integer>
  bool integer(Integer& i)
  {
    const std::string_view text = word();
    const auto result = std::from_chars(text.data(), text.data() + text.size(), i);
    return !text.empty() && result.ec == std::errc() && result.ptr == text.data() + text.size();
  }

  static bool parse(std::string_view text, double& x)
  {
    if(!text.empty() && text.front() == '+')
      text.remove_prefix(1);
#ifdef __cpp_lib_to_chars
    const auto result = std::from_chars(text.data(), text.data() + text.size(), x);
    if(result.ec != std::errc::result_out_of_range)
      return result.ec == std::errc() && result.ptr == text.data() + text.size();
#endif
    const std::string copy(text); // strtod knows of underflow
    char* end = nullptr;
    x = std::strtod(copy.c_str(), &end);
    return !copy.empty() && end == copy.c_str() + copy.size();
  }

private:
  // Whether we are at a backslash that ends a line.
  bool is_continuation() const
  {
    return m_lines_continue && m_at != m_end && *m_at == '\\'
           && (m_end - m_at == 1 || m_at[1] == '\n' || (m_at[1] == '\r' && m_end - m_at > 2 && m_at[2] == '\n'));
  }

  // Comments end with their line, whatever is in them.
  static bool is_continued(const char* begin, const char* end)
  {
    if(std::memchr(begin, '#', std::size_t(end - begin)))
      return false;
    return (end - begin >= 1 && end[-1] == '\\') || (end - begin >= 2 && end[-1] == '\r' && end[-2] == '\\');
  }
};

#endif // GRADIENT_DOMAIN_FILTER_FILES_TEXT_SCANNER_H
