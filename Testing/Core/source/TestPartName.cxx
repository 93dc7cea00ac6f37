// SPDX-License-Identifier: BSD-3-Clause
// What messages call parts of an input.
#include "source/PartName.h"

#include <gtest/gtest.h>

using geodesic::PartName;

TEST(PartName, NamesAPartOfAPartOfTheInput)
{
  const PartName source("the source (input port 1)");
  EXPECT_EQ(source.text(), "the source (input port 1)");
  EXPECT_EQ(source.withoutInput(), "");
  const PartName point = source.part("cell", 2).part("point", 3);
  EXPECT_EQ(point.text(), "point 3 of cell 2 of the source (input port 1)");
  EXPECT_EQ(point.withoutInput(), "point 3 of cell 2");
  EXPECT_EQ(point.onRank(4).text(), "point 3 of cell 2 of the source (input port 1) on rank 4");
}

TEST(PartName, BeginsASentenceWithACapitalIfItBeginsWithALetter)
{
  EXPECT_EQ(PartName("the surface").atBeginning(), "The surface");
  EXPECT_EQ(PartName("the surface").part("Wing").atBeginning(), "Wing of the surface");
  EXPECT_EQ(PartName("2nd input").atBeginning(), "2nd input");
  EXPECT_EQ(PartName().atBeginning(), "");
}
