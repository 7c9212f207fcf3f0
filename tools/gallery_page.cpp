// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/html.hpp"
#include "embedded.hpp"
#include "gallery.hpp"

namespace texel::tools {
namespace {

std::string size_attributes(const course::Look& look) {
  return fmt::format("width=\"{}\" height=\"{}\"", look.size.width, look.size.height);
}

/// A line is broken between flags, not within them.
std::string unbroken_flags(const std::string& command) {
  std::string html = "<span>" + html_escaped(command) + "</span>";
  for (std::size_t at = html.find(" --"); at != std::string::npos; at = html.find(" --", at + 15))
    html.replace(at, 1, "</span> <span>");
  return html;
}

std::string command_line(const std::string& command) {
  return fmt::format(
      "<div class=\"command\"><code>{}</code><button type=\"button\" class=\"copy\" "
      "aria-label=\"Copy the command\">Copy</button></div>",
      unbroken_flags(command));
}

std::string anchor(const course::Lab& lab, const course::Look& look) {
  return lab.folder + "-" + look.name;
}

/// The values of the settings that choose a method, as "averaged", or "default".
std::vector<std::string> methods_of(const course::Look& look) {
  std::vector<std::string> methods;
  for (const course::Setting& setting : look.settings)
    if (setting.parameter.ends_with("method")) methods.push_back(setting.value);
  if (methods.empty()) methods.emplace_back("default");
  return methods;
}

/// Whether two pictures show the same, apart from one parameter.
bool is_pair(const course::Look& a, const course::Look& b) {
  if (a.view != b.view || a.size != b.size || a.settings == b.settings) return false;
  std::set<std::string> different;
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (const course::Setting& setting : from->settings)
      if (std::ranges::count(to->settings, setting) == 0) different.insert(setting.parameter);
  return different.size() == 1;
}

/// The picture that a reader would put beside this one, or null.
const course::Look* partner(const course::Lab& lab, const course::Look& look) {
  for (const course::Look& other : lab.looks)
    if (is_pair(look, other)) return &other;
  return nullptr;
}

std::string hero(const course::Lab& lab, const course::Look& look) {
  return fmt::format("<a href=\"#{}\"><img src=\"{}\" alt=\"{}\" {}><span><b>{}</b> {}</span></a>\n",
                     anchor(lab, look), picture(lab, look), html_escaped(look.caption), size_attributes(look),
                     lab.number, html_escaped(lab.title));
}

std::string figure(const course::Lab& lab, const course::Look& look) {
  const std::string source =
      look.source.empty() ? "" : fmt::format("<p class=\"source\">{}</p>", html_escaped(look.source));
  const std::string view = look.view == course::View::color
                               ? ""
                               : fmt::format("<span class=\"view\">{} view</span>", name_of(look.view));
  const course::Look* other = partner(lab, look);
  const std::string pair = other == nullptr ? "" : fmt::format(" data-pair=\"{}\"", anchor(lab, *other));
  const std::string compare =
      other == nullptr ? ""
                       : fmt::format("<button type=\"button\" class=\"compare\">Compare with: {}</button>",
                                     html_escaped(other->caption));
  return fmt::format(
      "<figure id=\"{}\" data-view=\"{}\" data-methods=\"{}\"{}>\n"
      "<a class=\"open\" href=\"{}\"><img src=\"{}\" alt=\"{}\" {} loading=\"lazy\">{}</a>\n"
      "<figcaption><p class=\"caption\">{}</p>{}{}{}</figcaption>\n</figure>\n",
      anchor(lab, look), name_of(look.view), fmt::join(methods_of(look), " "), pair, picture(lab, look),
      picture(lab, look), html_escaped(look.caption), size_attributes(look), view, html_escaped(look.caption),
      source, compare, command_line(course::command(lab, look)));
}

std::string section(const course::Lab& lab) {
  std::string html = fmt::format(
      "<section id=\"lab{0}\" class=\"lab\" aria-labelledby=\"title{0}\">\n<header>\n"
      "<p class=\"number\" aria-hidden=\"true\">{0}</p>\n<div><h2 "
      "id=\"title{0}\">{1}</h2>\n<p>{2}</p></div>\n{3}\n"
      "</header>\n<div class=\"looks\">\n",
      lab.number, html_escaped(lab.title), html_escaped(lab.lesson),
      command_line(fmt::format("./run lab {}", lab.number)));
  for (const course::Look& look : lab.looks) html += figure(lab, look);
  return html + "</div>\n</section>\n";
}

/// A choice of one of the values; the first stands for all.
std::string choice(const char* id, const char* label, const std::map<std::string, std::string>& values) {
  std::string options;
  for (const auto& [value, text] : values)
    options += fmt::format("<option value=\"{}\">{}</option>", value, html_escaped(text));
  return fmt::format("<label>{1} <select id=\"{0}\"><option value=\"\">all</option>{2}</select></label>\n",
                     id, label, options);
}

std::string filters(const std::vector<course::Lab>& labs) {
  std::map<std::string, std::string> numbers, views, methods;
  for (const course::Lab& lab : labs) {
    numbers[fmt::format("lab{}", lab.number)] = fmt::format("{} {}", lab.number, lab.title);
    for (const course::Look& look : lab.looks) {
      views[name_of(look.view)] = name_of(look.view);
      for (const std::string& method : methods_of(look)) methods[method] = method;
    }
  }
  return "<form class=\"filters\">\n" + choice("lab", "Lab", numbers) + choice("view", "View", views) +
         choice("method", "Method", methods) + "<output></output>\n</form>\n";
}

constexpr const char* kLightbox =
    "<dialog id=\"lightbox\" aria-label=\"Picture\">\n"
    "<div class=\"stage\"><img alt=\"\"><img class=\"over\" alt=\"\" hidden></div>\n"
    "<label class=\"split\" hidden><span></span><input type=\"range\" min=\"0\" max=\"100\" value=\"50\" "
    "aria-label=\"How much of each picture is shown\"><span></span></label>\n"
    "<div class=\"bar\"><button type=\"button\" data-step=\"-1\" aria-label=\"Previous "
    "picture\">&#8592;</button>\n"
    "<p><b></b><span></span></p>\n"
    "<button type=\"button\" data-step=\"1\" aria-label=\"Next picture\">&#8594;</button>\n"
    "<button type=\"button\" data-close aria-label=\"Close\">&#215;</button></div>\n</dialog>\n";

}  // namespace

std::string gallery_page(const std::vector<course::Lab>& labs, const std::string& renderer) {
  std::string heroes, contents, sections;
  for (const course::Lab& lab : labs) {
    contents +=
        fmt::format("<li><a href=\"#lab{0}\"><b>{0}</b> {1}</a></li>\n", lab.number, html_escaped(lab.title));
    sections += section(lab);
    for (const course::Look& look : lab.looks)
      if (look.hero) heroes += hero(lab, look);
  }
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n"
      "<title>Texel Labs: gallery</title>\n<style>\n{}</style>\n</head>\n<body>\n"
      "<header class=\"masthead\">\n<h1>Texel Labs</h1>\n"
      "<p>Texture mapping, normal mapping and environment mapping in small OpenGL programs. Each "
      "picture was "
      "drawn by the command below it, typed in the project&#8217;s folder. Without <code>--snapshot</code> "
      "the same "
      "command opens that look in a window.</p>\n</header>\n"
      "<div class=\"heroes\">\n{}</div>\n<nav aria-label=\"Labs\"><ol>\n{}</ol></nav>\n<main>\n{}{}</main>\n"
      "<footer><p>Drawn by {}.</p></footer>\n{}<script>\n{}</script>\n</body>\n</html>\n",
      kGalleryStyle, heroes, contents, filters(labs), sections, html_escaped(renderer), kLightbox,
      kGalleryScript);
}

}  // namespace texel::tools
