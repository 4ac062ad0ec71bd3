#pragma once
#include "arap.h"
#include "page.h"
#include "subject.h"

namespace burin::paper {

/// Parameterizations of one stroke's region, side by side.
class Comparison {
 public:
  explicit Comparison(const Subject& subject);

  void add(const std::string& name, const Parameterization& places);

  /// Pictures, and a table of the errors of |d| and of the triangles turned over.
  void show(Page& page) const;

 private:
  const Subject& subject_;
  std::vector<test::ExactNode> exact_;
  std::vector<Page::Captioned> pictures_;
  std::vector<std::vector<std::string>> rows_;
};

/// The region under these constraints.
Parameterization dncp_of(const Subject& subject, std::span<const Constraint> constraints);

/// The ARAP parameterization, started from DNCP under the same constraints.
Parameterization arap_of(const Subject& subject, std::span<const Constraint> constraints);

}  // namespace burin::paper
