{
  open Scc_base
  open Parser

  type lexeme =
    | Token of Parser.token
    | Newline
    | Line_comment
    | Block_comment
    | Fault of fault

  and fault = {
    code : Code.t;
    message : string;
    hint : string option;
    opening : bool;
    instead : Parser.token option;
  }

  let words = Word_tokens.all

  module Words = Map.Make (String)

  let table = List.fold_left (fun m (w, t) -> Words.add w t m) Words.empty words

  let word w = match Words.find_opt w table with Some t -> t | None -> NAME w

  let fault ?hint ?instead ?(opening = false) code message =
    Fault { code; message; hint; opening; instead }

  (* What people type when they mean a mark of the language. *)
  let mark text right instead =
    fault Code.lexical
      (Printf.sprintf "`%s` is not a mark of the language" text)
      ~hint:(Printf.sprintf "write `%s`" right) ~instead

  let number text =
    match Scc_exact.Rat.of_literal text with
    | Ok q -> Token (NUMBER q)
    | Error Too_large ->
      fault Code.number_too_large
        (Printf.sprintf "this number has more than %d digits when written out" Scc_exact.Rat.max_digits)
        ~instead:(NUMBER Scc_exact.Rat.one)
    | Error (Malformed | Zero_denominator) -> Bug.fail __POS__ ("not a number: " ^ text)

  (* 2^-k, for the digits of k: a number of k decimal places. *)
  let power_of_two digits =
    match int_of_string_opt digits with
    | Some k when k <= Scc_exact.Rat.max_digits -> Token (NUMBER (Q.make Z.one (Z.shift_left Z.one k)))
    | Some _ | None ->
      fault Code.number_too_large
        (Printf.sprintf "this number has more than %d digits when written out" Scc_exact.Rat.max_digits)
        ~instead:(NUMBER Scc_exact.Rat.one)

  (* The letter under a macron. Code points that carry none stand for themselves. *)
  let unbarred = function
    | 0x100 -> 'A' | 0x101 -> 'a' | 0x112 -> 'E' | 0x113 -> 'e' | 0x12A -> 'I' | 0x12B -> 'i'
    | 0x14C -> 'O' | 0x14D -> 'o' | 0x16A -> 'U' | 0x16B -> 'u' | 0x232 -> 'Y' | 0x233 -> 'y'
    | 0x1E20 -> 'G' | 0x1E21 -> 'g'
    | c -> Bug.fail __POS__ (Printf.sprintf "no barred letter: U+%04X" c)

  (* The name under the bars: combining marks dropped, letters with a macron replaced. *)
  let strip_bars text =
    let b = Buffer.create (String.length text) in
    let rec from i =
      if i < String.length text then
        match text.[i] with
        | '\xCC' -> from (i + 2)
        | '\xC4' .. '\xC8' ->
          Buffer.add_char b (unbarred (Utf8.code_point (String.sub text i 2)));
          from (i + 2)
        | '\xE1' ->
          Buffer.add_char b (unbarred (Utf8.code_point (String.sub text i 3)));
          from (i + 3)
        | c ->
          Buffer.add_char b c;
          from (i + 1)
    in
    from 0;
    Buffer.contents b

  let barred text =
    match word (strip_bars text) with
    | NAME n -> Token (BARRED n)
    | BOND | MASS | EVENT | DYNAMICS | COLLISIONS | BINDING | BONDS | BLOCKED | RESOLUTION | ROUND | SNAP | GRID | WELD | ORIENT | MERGE | UNION
    | DECOMPOSE
    | LETTER _ | MOD | HULL | AS | WHERE | U | A | E | AF | AG | AX | EF | EG | EX -> Token (BARRED (strip_bars text))
    | _ ->
      fault Code.lexical
        (Printf.sprintf "`%s` is a word of the language and cannot be a co-name" (strip_bars text))
        ~instead:(BARRED "_")

  let unknown text =
    let hint =
      match text with
      | "\xE2\x88\x92" | "\xE2\x80\x93" | "\xE2\x80\x94" -> Some "write `-`"
      | "\xC3\x97" -> Some "write `*`"
      | "\xE2\x89\xA4" -> Some "write `<=`"
      | "\xE2\x89\xA5" -> Some "write `>=`"
      | "\xE2\x89\xA0" -> Some "write `!=`"
      | "\xE2\x88\xA7" -> Some "write `and`"
      | "\xE2\x88\xA8" -> Some "write `or`"
      | "\xC2\xAC" -> Some "write `not`"
      | "\xE2\x80\x9C" | "\xE2\x80\x9D" | "'" -> Some "a string stands between two `\"`"
      | "^" -> Some "the only powers that can be written are `2^-1`, `2^-2` and so on"
      | "\xC2\xA0" -> Some "this is a no-break space: write an ordinary one"
      | _ when Utf8.code_point text > 0x7F -> Some "names are made of ASCII letters, digits, `_` and `'`"
      | _ -> None
    in
    fault ?hint Code.lexical
      (if Utf8.code_point text > 0x7F then
         Printf.sprintf "the character `%s` (U+%04X) is not of the language" text (Utf8.code_point text)
       else Printf.sprintf "the character `%s` is not of the language" text)
}

let letter = ['a'-'z' 'A'-'Z']
let digit = ['0'-'9']
let bar = "\xCC\x84" | "\xCC\x85"
let macron =
  "\xC4\x80" | "\xC4\x81" | "\xC4\x92" | "\xC4\x93" | "\xC4\xAA" | "\xC4\xAB" | "\xC5\x8C" | "\xC5\x8D"
  | "\xC5\xAA" | "\xC5\xAB" | "\xC8\xB2" | "\xC8\xB3" | "\xE1\xB8\xA0" | "\xE1\xB8\xA1"
let rest = letter | digit | '_' | '\''
let name = letter rest*
let barred_name = (letter | macron) (rest | macron | bar)*
let number = digit+ ('.' digit+)? (['e' 'E'] ['+' '-']? digit+)?
let wide = ['\xC0'-'\xFF'] ['\x80'-'\xBF']*

rule next = parse
| [' ' '\t' '\012']+ | "\xEF\xBB\xBF" { next lexbuf }
| '\n' | '\r' '\n' | '\r' { Newline }
| "//" [^ '\n' '\r']* { Line_comment }
| "/*" { block lexbuf.Lexing.lex_start_p 1 lexbuf }
| '"' { text (Buffer.create 40) (Lexing.lexeme_start_p lexbuf) lexbuf }
| number { number (Lexing.lexeme lexbuf) }
| "2^-" (digit+ as k) { power_of_two k }
| name { Token (word (Lexing.lexeme lexbuf)) }
| barred_name { barred (Lexing.lexeme lexbuf) }
| '(' { Token LPAREN } | ')' { Token RPAREN }
| '[' { Token LBRACKET } | ']' { Token RBRACKET }
| '{' { Token LBRACE } | '}' { Token RBRACE }
| ',' { Token COMMA } | ':' { Token COLON } | ".." { Token DOTDOT }
| '.' | "\xC2\xB7" | "\xE2\x8B\x85" { Token DOT }
| '~' { Token TILDE }
| "||" | "\xE2\x80\x96" | "\xE2\x88\xA5" { Token PARALLEL }
| '<' | "\xE2\x9F\xA8" | "\xE2\x8C\xA9" | "\xE3\x80\x88" { Token LT }
| '>' | "\xE2\x9F\xA9" | "\xE2\x8C\xAA" | "\xE3\x80\x89" { Token GT }
| "<=" { Token LE } | ">=" { Token GE } | '=' { Token EQ } | '?' { Token QUESTION } | "!=" { Token NE } | "=>" { Token IMPLIES }
| '+' { Token PLUS } | '-' { Token MINUS } | '*' { Token STAR } | '/' { Token SLASH }
| "\xCF\x89" { Token OMEGA }
| "\xCF\x81" | "\xCF\xB1" { Token RHO }
| "\xCE\xB5" | "\xCF\xB5" { Token EPS }
| "==" { mark "==" "=" EQ }
| "<>" { mark "<>" "!=" NE }
| "&&" { mark "&&" "and" AND }
| "->" { mark "->" "=>" IMPLIES }
| '!' { mark "!" "not" NOT }
| '&' { mark "&" "and" AND }
| '|' {
    fault Code.lexical "`|` is not a mark of the language" ~instead:OR
      ~hint:"write `or` between formulas, `||` between processes" }
| '_' rest* {
    fault Code.lexical "a name begins with a letter" ~instead:(NAME (Lexing.lexeme lexbuf)) }
| wide | _ { unknown (Lexing.lexeme lexbuf) }
| eof { Token EOF }

(* The two rules below give the whole comment or string as one lexeme: they set its start back to where it
   began. Block comments nest, so that a piece of a model that has comments can be put in one. *)

and block start depth = parse
| "/*" { block start (depth + 1) lexbuf }
| "*/" {
    if depth > 1 then block start (depth - 1) lexbuf
    else begin
      lexbuf.Lexing.lex_start_p <- start;
      Block_comment
    end }
| [^ '/' '*']+ | '/' | '*' { block start depth lexbuf }
| eof {
    lexbuf.Lexing.lex_start_p <- start;
    fault Code.unterminated "this comment is not closed" ~hint:"close it with `*/`" ~opening:true }

and text buffer start = parse
| '"' {
    lexbuf.Lexing.lex_start_p <- start;
    Token (STRING (Buffer.contents buffer)) }
| '\\' (['"' '\\'] as c) { Buffer.add_char buffer c; text buffer start lexbuf }
| [^ '"' '\\' '\n' '\r']+ { Buffer.add_string buffer (Lexing.lexeme lexbuf); text buffer start lexbuf }
| '\\' { Buffer.add_char buffer '\\'; text buffer start lexbuf }
| '\n' | '\r' | eof {
    lexbuf.Lexing.lex_curr_p <- lexbuf.Lexing.lex_start_p;
    lexbuf.Lexing.lex_curr_pos <- lexbuf.Lexing.lex_start_pos;
    lexbuf.Lexing.lex_start_p <- start;
    fault Code.unterminated "this string is not closed on its line" ~hint:"close it with `\"`"
      ~instead:(STRING (Buffer.contents buffer)) }
