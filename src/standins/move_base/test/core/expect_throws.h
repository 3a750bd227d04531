#pragma once

#include <gtest/gtest.h>

#include <string>

/// Expects an exception of exactly this message.
#define EXPECT_THROWS_MESSAGE(statement, exception, message) \
  try {                                                      \
    statement;                                               \
    ADD_FAILURE() << "nothing was thrown";                   \
  } catch (const exception & error) {                        \
    EXPECT_EQ(std::string(error.what()), message);           \
  }
