// SPDX-License-Identifier: GPL-3.0-or-later
#include "Manifest.h"

#include "point_files/Temporary_file.h"
#include "settings_to_json.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace balanced_flow_blocks {

namespace {

constexpr int layout_version = 2; // of the working directory

typedef nlohmann::ordered_json Json;

std::string read_text(const std::filesystem::path& path)
{
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in)
    throw std::runtime_error("cannot read " + path.string());
  return text.str();
}

void write_pages(const std::filesystem::path& path, const std::vector<Page>& pages)
{
  point_files::Temporary_file file(path);
  file.stream().write(reinterpret_cast<const char*>(pages.data()),
                      std::streamsize(pages.size() * sizeof(Page)));
  file.take_place();
}

Json to_json(const Input_file& input)
{
  return {{"path", input.path.string()}, {"output", input.output.string()},
          {"format", input.format},      {"size", input.size},
          {"time", input.time},          {"first", input.first},
          {"count", input.count},        {"invalid", input.invalid}};
}

Input_file input_from_json(const Json& json)
{
  Input_file input;
  input.path = json.at("path").get<std::string>();
  input.output = json.at("output").get<std::string>();
  input.format = json.at("format");
  input.size = json.at("size");
  input.time = json.at("time");
  input.first = json.at("first");
  input.count = json.at("count");
  input.invalid = json.at("invalid");
  return input;
}

std::filesystem::path manifest_file(const std::filesystem::path& directory)
{
  return directory / "manifest.json";
}

} // namespace

void Input_file::look_at_file()
{
  size = std::filesystem::file_size(path);
  time = std::filesystem::last_write_time(path).time_since_epoch().count();
}

void Input_file::check_unchanged() const
{
  Input_file now = *this;
  try {
    now.look_at_file();
  }
  catch (const std::filesystem::filesystem_error& e) {
    throw std::runtime_error(path.string() + ": " + e.code().message());
  }
  if (now.size != size || now.time != time)
    throw std::runtime_error(
        path.string() + " was changed since it was planned: plan it again, in a new directory");
}

bool Manifest::exists(const std::filesystem::path& directory)
{
  return std::filesystem::exists(manifest_file(directory));
}

Manifest Manifest::read(const std::filesystem::path& directory)
{
  if (!exists(directory))
    throw std::runtime_error(directory.string() +
                             " is not a planned directory: the command plan makes one");
  const std::string text = read_text(manifest_file(directory));
  Manifest manifest;
  manifest.directory = directory;
  manifest.checksum = Checksum::of(text.data(), text.size());
  try {
    const Json json = Json::parse(text);
    if (json.at("layout") != layout_version)
      throw std::runtime_error("it is of another version of this program");
    manifest.settings = settings_from_json(json.at("settings"));
    manifest.memory = json.at("memory");
    manifest.block_size = json.at("block_size");
    manifest.has_normals = json.at("has_normals");
    manifest.writes_normals = json.at("writes_normals");
    manifest.number_of_points = json.at("points");
    manifest.scans = json.at("scans").get<std::vector<std::uint64_t>>();
    if (!json.at("sided_points").is_null())
      manifest.sided_points = json.at("sided_points").get<std::uint64_t>();
    const auto center = json.at("frame").at("center").get<std::array<double, 3>>();
    manifest.frame.center = {center[0], center[1], center[2]};
    manifest.frame.unit = json.at("frame").at("unit");
    for (const Json& input : json.at("inputs"))
      manifest.inputs.push_back(input_from_json(input));
    std::uint32_t page_count = 0;
    for (const Json& block : json.at("blocks")) {
      manifest.blocks.push_back({block.at(0), page_count, block.at(1)});
      page_count += manifest.blocks.back().page_count;
    }
    const std::string pages = read_text(directory / "pages");
    if (pages.size() != page_count * sizeof(Page) ||
        Checksum::of(pages.data(), pages.size()) != json.at("pages_checksum").get<std::uint64_t>())
      throw std::runtime_error("its index of pages is damaged");
    manifest.pages.resize(page_count);
    std::memcpy(static_cast<void*>(manifest.pages.data()), pages.data(), pages.size());
  }
  catch (const std::exception& e) {
    throw std::runtime_error(directory.string() + " can not be used: " + e.what() +
                             "; plan again, in a new directory");
  }
  return manifest;
}

void Manifest::write()
{
  write_pages(directory / "pages", pages);
  Json json;
  json["program"] = "balanced-flow-blocks";
  json["version"] = POINT_SET_FLOW_VERSION;
  json["layout"] = layout_version;
  json["settings"] = settings_to_json(settings);
  json["memory"] = memory;
  json["block_size"] = block_size;
  json["has_normals"] = has_normals;
  json["writes_normals"] = writes_normals;
  json["points"] = number_of_points;
  json["scans"] = scans;
  json["sided_points"] = sided_points ? Json(*sided_points) : Json();
  json["frame"] = {{"center", {frame.center.x(), frame.center.y(), frame.center.z()}},
                   {"unit", frame.unit}};
  json["inputs"] = Json::array();
  for (const Input_file& input : inputs)
    json["inputs"].push_back(to_json(input));
  json["blocks"] = Json::array(); // number of points, number of pages
  for (const Block& block : blocks)
    json["blocks"].push_back({block.count, block.page_count});
  json["pages_checksum"] =
      Checksum::of(reinterpret_cast<const char*>(pages.data()), pages.size() * sizeof(Page));
  const std::string text = json.dump(1) + "\n";
  checksum = Checksum::of(text.data(), text.size());
  point_files::Temporary_file file(manifest_file(directory));
  file.stream() << text;
  file.take_place();
}

std::filesystem::path Manifest::points_file(std::size_t block) const
{
  return directory / "blocks" / (std::to_string(block) + ".points");
}

std::filesystem::path Manifest::result_file(std::size_t block) const
{
  return directory / "results" / (std::to_string(block) + ".result");
}

} // namespace balanced_flow_blocks
