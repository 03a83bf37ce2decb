// What the grammar cannot tell by regular expressions: names, as opposed to the words of the language; comments that
// nest; a `[` whose `]` has a colon after it (the indices of a label); and a division by a literal zero, which is refused.

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "tree_sitter/parser.h"
#include "words.h"

enum token { NAME, BARRED_NAME, BRACKET, LABEL_BRACKET, SLASH, BLOCK_COMMENT, NEVER, REFUSED };

// Longer words are names.
enum { LONGEST = 15 };

static bool is_space(int32_t c) {
  return c == ' ' || c == '\t' || c == '\f' || c == '\r' || c == '\n' || c == 0xFEFF;
}

// No text has other control characters.
static bool is_text(int32_t c) { return c >= 0xA0 || (c >= 0x20 && c < 0x7F) || is_space(c); }

static bool is_digit(int32_t c) { return c >= '0' && c <= '9'; }
static bool is_letter(int32_t c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
static bool goes_on(int32_t c) { return is_letter(c) || is_digit(c) || c == '_' || c == '\''; }

static bool is_bar(int32_t c) { return c == 0x304 || c == 0x305; }

// The letter under a macron, or 0.
static char unbarred(int32_t c) {
  static const struct { int32_t barred; char letter; } letters[] = {
    {0x100, 'A'}, {0x101, 'a'}, {0x112, 'E'}, {0x113, 'e'}, {0x12A, 'I'}, {0x12B, 'i'}, {0x14C, 'O'}, {0x14D, 'o'},
    {0x16A, 'U'}, {0x16B, 'u'}, {0x232, 'Y'}, {0x233, 'y'}, {0x1E20, 'G'}, {0x1E21, 'g'},
  };
  for (size_t i = 0; i < sizeof letters / sizeof *letters; i++)
    if (letters[i].barred == c) return letters[i].letter;
  return 0;
}

static void advance(TSLexer *lexer) { lexer->advance(lexer, false); }

// Reads a word without its bars: its first characters, and whether it had bars.
static bool read_word(TSLexer *lexer, char word[LONGEST + 1]) {
  size_t length = 0;
  bool barred = false;
  for (;; advance(lexer)) {
    int32_t c = lexer->lookahead;
    char letter = unbarred(c);
    if (letter || is_bar(c)) barred = true;
    else if (!goes_on(c)) break;
    if (!is_bar(c) && length <= LONGEST) word[length++] = letter ? letter : (char)c;
  }
  // One that is too long is none of the table.
  word[length <= LONGEST ? length : 0] = 0;
  return barred;
}

static bool is_word(const char *word) {
  for (size_t i = 0; i < sizeof words / sizeof *words; i++)
    if (!strcmp(words[i], word)) return true;
  return false;
}

static bool is_one_of(const char *list, const char *word) {
  size_t length = strlen(word);
  for (const char *at = list; length && (at = strstr(at, word)); at += length)
    if ((at == list || at[-1] == ' ') && (at[length] == ' ' || !at[length])) return true;
  return false;
}

// The words that begin a declaration wherever they stand, so that no bracket is open there.
static bool begins_declaration(const char *word) {
  return is_one_of("model import param timestep split_step shape compound process fixed for network motion let check", word);
}

// The words that can be the name of a channel under a bar.
static bool can_be_barred(const char *word) {
  return is_one_of("A E F G U X AF AG AX EF EG EX as binding blocked bond bonds collisions decompose dynamics event grid "
                   "hull mass merge mod orient resolution round snap union weld where", word);
}

// After `/*`, up to the end of the comment: whether it has one.
static bool read_comment(TSLexer *lexer) {
  for (unsigned depth = 1; depth;) {
    int32_t c = lexer->lookahead;
    if (lexer->eof(lexer) || !is_text(c)) return false;
    advance(lexer);
    if (c == '/' && lexer->lookahead == '*') { advance(lexer); depth++; }
    else if (c == '*' && lexer->lookahead == '/') { advance(lexer); depth--; }
  }
  return true;
}

static void read_line(TSLexer *lexer) {
  while (!lexer->eof(lexer) && lexer->lookahead != '\n' && lexer->lookahead != '\r') advance(lexer);
}

// Passes over spaces and comments. False if a mark `/` stands there, which was read.
static bool pass_trivia(TSLexer *lexer) {
  for (;;) {
    if (is_space(lexer->lookahead)) advance(lexer);
    else if (lexer->lookahead == '/') {
      advance(lexer);
      if (lexer->lookahead == '/') read_line(lexer);
      else if (lexer->lookahead == '*') { advance(lexer); read_comment(lexer); }
      else return false;
    }
    else return true;
  }
}

// Whether a number that is 0 stands here.
static bool is_zero(TSLexer *lexer) {
  bool zero = true;
  if (!is_digit(lexer->lookahead)) return false;
  for (; is_digit(lexer->lookahead); advance(lexer)) zero = zero && lexer->lookahead == '0';
  if (!zero || lexer->lookahead != '.') return zero;
  for (advance(lexer); is_digit(lexer->lookahead); advance(lexer)) zero = zero && lexer->lookahead == '0';
  return zero;
}

static void read_string(TSLexer *lexer) {
  for (advance(lexer); !lexer->eof(lexer) && lexer->lookahead != '"' && lexer->lookahead != '\n'; advance(lexer))
    if (lexer->lookahead == '\\') advance(lexer);
  advance(lexer);
}

// After a `[`: whether its `]` has a colon after it. Brackets that do not match are passed over, as the parser does.
static bool has_label(TSLexer *lexer) {
  enum { DEEPEST = 1000 };
  char open[DEEPEST];
  unsigned depth = 0;
  for (;;) {
    if (!pass_trivia(lexer)) continue;
    if (lexer->eof(lexer)) return false;
    int32_t c = lexer->lookahead;
    if (c == '"') read_string(lexer);
    else if (is_letter(c) || unbarred(c)) {
      char word[LONGEST + 1];
      if (read_word(lexer, word)) continue;
      if (begins_declaration(word)) return false;
      if (!strcmp(word, "behaviour")) {
        if (!pass_trivia(lexer) || lexer->lookahead != '(') return false;
      }
    }
    else if (is_digit(c)) {
      // A number ends before its letters, but for those of an exponent, which no word of the language begins with here.
      while (is_digit(lexer->lookahead)) advance(lexer);
    }
    else {
      advance(lexer);
      if (c == '[' || c == '(' || c == '{') {
        if (depth == DEEPEST) return false;
        open[depth++] = (char)c;
      }
      else if (c == ']' || c == ')' || c == '}') {
        char opening = c == ']' ? '[' : c == ')' ? '(' : '{';
        if (depth == 0 && c == ']') return pass_trivia(lexer) && lexer->lookahead == ':';
        if (depth > 0 && open[depth - 1] == opening) depth--;
      }
    }
  }
}

void *tree_sitter_scc_external_scanner_create(void) { return NULL; }
void tree_sitter_scc_external_scanner_destroy(void *payload) { (void)payload; }
unsigned tree_sitter_scc_external_scanner_serialize(void *payload, char *buffer) { (void)payload; (void)buffer; return 0; }
void tree_sitter_scc_external_scanner_deserialize(void *payload, const char *buffer, unsigned length) {
  (void)payload; (void)buffer; (void)length;
}

static bool found(TSLexer *lexer, enum token token) {
  lexer->result_symbol = token;
  return true;
}

// Whatever is expected: a token that does not fit is refused by the grammar, and must not be read as two that do.
bool tree_sitter_scc_external_scanner_scan(void *payload, TSLexer *lexer, const bool *valid) {
  (void)payload; (void)valid;
  while (is_space(lexer->lookahead)) lexer->advance(lexer, true);
  int32_t c = lexer->lookahead;
  if (is_letter(c) || unbarred(c)) {
    char word[LONGEST + 1];
    bool barred = read_word(lexer, word);
    lexer->mark_end(lexer);
    if (barred) return found(lexer, is_word(word) && !can_be_barred(word) ? REFUSED : BARRED_NAME);
    return !is_word(word) && found(lexer, NAME);
  }
  if (c == '[') {
    advance(lexer);
    lexer->mark_end(lexer);
    return found(lexer, has_label(lexer) ? LABEL_BRACKET : BRACKET);
  }
  if (c == '/') {
    advance(lexer);
    if (lexer->lookahead == '/') return false;
    if (lexer->lookahead == '*') {
      advance(lexer);
      bool closed = read_comment(lexer);
      lexer->mark_end(lexer);
      return closed && found(lexer, BLOCK_COMMENT);
    }
    lexer->mark_end(lexer);
    return found(lexer, pass_trivia(lexer) && is_zero(lexer) ? REFUSED : SLASH);
  }
  return false;
}
