#include "renderer/scene/gltf_file/data_uri.h"

#include <gtest/gtest.h>

namespace foveola::test {
namespace {

/// RFC 4648, section 10.
TEST(DataUri, HoldsBase64) {
  EXPECT_EQ(bytes_of_data_uri("data:image/png;base64,Zm9vYmFy"), "foobar");
  EXPECT_EQ(bytes_of_data_uri("data:image/png;base64,Zm9vYmE="), "fooba");
  EXPECT_EQ(bytes_of_data_uri("data:image/png;base64,Zm9vYg=="), "foob");
  EXPECT_EQ(bytes_of_data_uri("data:image/png;base64,Zm9vYg"), "foob");
  EXPECT_EQ(bytes_of_data_uri("data:image/png;base64,"), "");
}

TEST(DataUri, MayHaveAnyTypeAndParameters) {
  EXPECT_EQ(bytes_of_data_uri("DATA:Application/Octet-Stream;charset=utf-8;BASE64,Zm9v"), "foo");
  EXPECT_EQ(bytes_of_data_uri("data:;base64,Zm9v"), "foo");
  EXPECT_EQ(bytes_of_data_uri("data:image/x-unheard-of;base64,Zm9v"), "foo");
}

TEST(DataUri, MayBePercentEncoded) {
  EXPECT_EQ(bytes_of_data_uri("data:text/plain,a%20b"), "a b");
  EXPECT_EQ(bytes_of_data_uri("data:;base64,Zm9vYg%3D%3D"), "foob");
}

TEST(DataUri, IsNoOther) {
  EXPECT_TRUE(is_data_uri("dAtA:,"));
  EXPECT_FALSE(is_data_uri("data.bin"));
  EXPECT_EQ(bytes_of_data_uri("data:image/png;base64"), std::nullopt);
  EXPECT_EQ(bytes_of_data_uri("data:image/png;base64,Zm9*"), std::nullopt);
  EXPECT_EQ(bytes_of_data_uri("date:;base64,Zm9v"), std::nullopt);
}

}  // namespace
}  // namespace foveola::test
