// Any bytes as a plant.json whose lists are all the same list.
#include "fuzz/target.hpp"

namespace symplant::fuzz {
namespace {

/// Every file except the description has the content of the fixed list.
class OneListEverywhere final : public base::FileSystem {
 public:
  explicit OneListEverywhere(std::string description) : description_(std::move(description)) {}

  base::Result<std::string, base::FileError> read(const std::string& path) const override {
    return path == "plant.json" ? description_ : std::string(fixed_list());
  }
  base::Result<bool, base::FileError> write(const std::string&, std::string_view) override { return refused(); }
  base::Result<bool, base::FileError> write_new(const std::string&, std::string_view) override { return refused(); }
  bool exists(const std::string&) const override { return true; }
  std::vector<std::string> list(const std::string&) const override { return {"a.csv", "b.csv"}; }

 private:
  static base::FileError refused() { return {"nothing is written here"}; }

  std::string description_;
};

}  // namespace
}  // namespace symplant::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const symplant::fuzz::OneListEverywhere files(std::string(reinterpret_cast<const char*>(data), size));
  symplant::fuzz::compile_all("plant.json", files);
  return 0;
}
