#include "app/command/manual.h"

#include "app/base/version.h"
#include "render/context.h"

namespace app {
namespace {

// Text as roff takes it: a hyphen that can be copied is \-, a line does not begin with a dot or a quote.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool first = out.empty() || out.back() == '\n';
    if (first && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
  }
  return out;
}

// "-o,--out DIR", "--every N", "SCENE"
std::string usage(const CLI::Option& option) {
  const std::string name = option.get_name(false, true);
  const std::string type = option.get_type_name().substr(0, option.get_type_name().find(':'));  // without its range
  return option.get_positional() || type.empty() ? name : name + " " + type;
}

void put_option_list(std::string& page, const CLI::App& command) {
  for (const CLI::Option* const option : command.get_options()) {
    page += ".TP\n.B " + roff(usage(*option)) + "\n" + roff(option->get_description());
    if (!option->get_default_str().empty()) page += roff(" [" + option->get_default_str() + "]");
    if (!option->get_envname().empty()) page += roff("; $" + option->get_envname() + " where it is not given");
    page += "\n";
  }
}

std::string contexts_of_this_build() {
  std::string names;
  for (const render::OffscreenKind& kind : render::offscreen_kinds()) names.append(kind.name).append(" ");
  return names;
}

std::string long_names(const CLI::App& command) {
  std::string names;
  for (const CLI::Option* const option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names += (names.empty() ? "--" : " --") + name;
  }
  return names;
}

// The names of options, between | as bash's case takes them, whose value is a file or a folder.
std::string of_files(const CLI::App& ritz) {
  std::string names;
  for (const CLI::App* const command : ritz.get_subcommands({})) {
    for (const CLI::Option* const option : command->get_options()) {
      const std::string type = option->get_type_name();
      if (option->get_positional() || (type != "FILE" && type != "DIR")) continue;
      for (const std::string& name : option->get_lnames()) {
        if (("|" + names + "|").find("|--" + name + "|") != std::string::npos) continue;
        names += (names.empty() ? "--" : "|--") + name;
      }
    }
  }
  return names;
}

}  // namespace

std::string manual_page(const CLI::App& ritz) {
  std::string page = ".TH RITZ 1 \"\" \"ritz " + std::string(ritz_version) + "\"\n.SH NAME\nritz \\- " +
                     roff(ritz.get_description()) + "\n.SH SYNOPSIS\n.B ritz\n.I COMMAND\n[\\fIOPTION\\fR ...]\n";
  page += ".SH OPTIONS\n";
  put_option_list(page, ritz);
  page += ".SH COMMANDS\n";
  for (const CLI::App* const command : ritz.get_subcommands({})) {
    page += ".SS ritz " + roff(command->get_name()) + "\n" + roff(command->get_description()) + "\n";
    put_option_list(page, *command);
  }
  return page + ".SH NOTES\n" + roff(ritz.get_footer()) + "\n";
}

std::string bash_completion(const CLI::App& ritz) {
  std::string commands, cases;
  for (const CLI::App* const command : ritz.get_subcommands({})) {
    commands += command->get_name() + " ";
    cases += "    " + command->get_name() + ") options='" + long_names(*command) + "' ;;\n";
  }
  return "# Completion of ritz for bash, made by `ritz --completion`.\n"
         "_ritz() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} options=\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    COMPREPLY=($(compgen -W '" +
         commands + long_names(ritz) +
         "' -- \"$word\"))\n"
         "    return\n"
         "  fi\n"
         "  case ${COMP_WORDS[1]} in\n" +
         cases +
         "  esac\n"
         "  case $before in\n"
         "    --context) COMPREPLY=($(compgen -W '" +
         contexts_of_this_build() +
         "' -- \"$word\")); return ;;\n"
         "    -o|" +
         of_files(ritz) +
         ") COMPREPLY=($(compgen -f -- \"$word\")); return ;;\n"
         "  esac\n"
         "  case $word in\n"
         "    -*) COMPREPLY=($(compgen -W \"$options\" -- \"$word\")) ;;\n"
         "    *) COMPREPLY=($(compgen -W \"$(ritz scenes --names 2>/dev/null)\" -- \"$word\") $(compgen -f -- "
         "\"$word\")) "
         ";;\n"
         "  esac\n"
         "}\n"
         "complete -o filenames -F _ritz ritz\n";
}

}  // namespace app
