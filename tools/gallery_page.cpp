// SPDX-License-Identifier: MIT
#include <fmt/format.h>

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
  return fmt::format(
      "<figure id=\"{}\">\n"
      "<a class=\"open\" href=\"{}\"><img src=\"{}\" alt=\"{}\" {} loading=\"lazy\">{}</a>\n"
      "<figcaption><p class=\"caption\">{}</p>{}{}</figcaption>\n</figure>\n",
      anchor(lab, look), picture(lab, look), picture(lab, look), html_escaped(look.caption),
      size_attributes(look), view, html_escaped(look.caption), source,
      command_line(course::command(lab, look)));
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

constexpr const char* kLightbox =
    "<dialog id=\"lightbox\" aria-label=\"Picture\">\n<img alt=\"\">\n"
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
      "<meta name=\"color-scheme\" content=\"light dark\">\n<link rel=\"icon\" href=\"data:,\">\n"
      "<title>Texel Labs: gallery</title>\n<style>\n{}</style>\n</head>\n<body>\n"
      "<header class=\"masthead\">\n<h1>Texel Labs</h1>\n"
      "<p>Texture mapping, normal mapping and environment mapping in small OpenGL programs. Each "
      "picture was "
      "drawn by the command below it, typed in the project&#8217;s folder. Without <code>--snapshot</code> "
      "the same "
      "command opens that look in a window.</p>\n</header>\n"
      "<div class=\"heroes\">\n{}</div>\n<nav aria-label=\"Labs\"><ol>\n{}</ol></nav>\n<main>\n{}</main>\n"
      "<footer><p>Drawn by {}.</p></footer>\n{}<script>\n{}</script>\n</body>\n</html>\n",
      kGalleryStyle, heroes, contents, sections, html_escaped(renderer), kLightbox, kGalleryScript);
}

}  // namespace texel::tools
