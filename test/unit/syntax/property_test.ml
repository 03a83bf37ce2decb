(* Properties of the reader and the printer over random models. *)

open Scc_base
open Scc_syntax
open Scc_test_trees
module Gen2 = QCheck2.Gen

let test ?(count = 250) name ?print gen law = QCheck2.Test.make ~count ~name ?print gen law

let print_model m = Printer.model m

let parse_print =
  test "parse (print m) = m" ~print:print_model Gen.model (fun m ->
      let text = Printer.model m in
      match Parse.parse (Support.source text) with
      | Ok m' -> Ast_equal.model m m'
      | Error ds -> QCheck2.Test.fail_report (Support.rendered text ds))

let parse_print_expr count name gen =
  test ~count name ~print:Printer.expr gen (fun e ->
      let text = Printer.expr e in
      match Parse.expression (Support.source text) with
      | Ok e' -> Ast_equal.expr e e'
      | Error ds -> QCheck2.Test.fail_report (Support.rendered text ds))

let format text =
  match Parse.with_trivia (Support.source text) with
  | Ok (m, trivia) -> (m, trivia, Printer.model ~trivia m)
  | Error ds -> QCheck2.Test.fail_report (Support.rendered text ds)

let print_idempotent =
  test "print (parse (print m)) = print m" ~print:print_model Gen.model (fun m ->
      let text = Printer.model m in
      let _, _, again = format text in
      String.equal text again)

(* Outside strings, a text means the same with a comment between any two tokens. *)
let with_comments (m, choices) =
  let text = Printer.model m in
  let t = Tokens.read (Support.source text) in
  let b = Buffer.create (2 * String.length text) in
  let marks = ref [] in
  let add k choice =
    let mark = Printf.sprintf "<%d>" k in
    let noted s =
      marks := mark :: !marks;
      Buffer.add_string b (Printf.sprintf s mark)
    in
    match choice with
    | 0 -> noted " // %s\n"
    | 1 -> noted "\n  // %s  \n"
    | 2 -> noted " /* %s */ "
    | 3 -> noted "\n/* %s\n   and more */\n"
    | 4 -> noted " /* %s\n*/"
    | 5 -> Buffer.add_string b "\n\n\n"
    | 6 -> Buffer.add_string b "\r\n"
    | _ -> ()
  in
  Array.iteri
    (fun i (token : Tokens.token) ->
       add i (List.nth choices (i mod List.length choices));
       Buffer.add_char b ' ';
       Buffer.add_string b (String.sub text token.start (token.stop - token.start)))
    t.tokens;
  (Buffer.contents b, !marks)

let commented = Gen2.pair Gen.model (Gen2.list_size (Gen2.int_range 1 40) (Gen2.int_range 0 30))
let print_commented c = fst (with_comments c)

let comments_kept =
  test "no comment is lost, and the tree stays the same" ~print:print_commented commented (fun (m, c) ->
      let text, marks = with_comments (m, c) in
      let m', _, printed = format text in
      let reread, _, _ = format printed in
      let lost = List.filter (fun mark -> not (Support.contains printed mark)) marks in
      let check what law = law || QCheck2.Test.fail_report (what ^ "\n" ^ printed) in
      check "another tree was read" (Ast_equal.model m m')
      && check "another tree was printed" (Ast_equal.model m reread)
      && check ("lost: " ^ String.concat " " lost) (lost = []))

let comments_idempotent =
  test "formatting is idempotent with comments" ~print:print_commented commented (fun c ->
      let text, _ = with_comments c in
      let _, _, once = format text in
      let _, _, twice = format once in
      String.equal once twice
      || QCheck2.Test.fail_report (Printf.sprintf "once:\n%s\ntwice:\n%s" once twice))

(* Any bytes, and pieces of models cut and joined at random: an answer, never an exception. *)
let total gen name =
  test ~count:250 name ~print:String.escaped gen (fun text ->
      match Parse.parse (Support.source text) with
      | Ok _ -> true
      | Error ds ->
        ds <> [] && List.length ds <= Parse.max_errors
        && String.length (Support.rendered text ds) > 0
        && List.for_all
          (fun (d : Diag.t) -> d.span.start >= 0 && d.span.stop <= String.length text)
          ds)

let bytes = Gen2.string_size ~gen:Gen2.char (Gen2.int_range 0 60)

let fragment =
  Gen2.oneofl
    (List.map fst Lexer.words
     @ [ "("; ")"; "["; "]"; "{"; "}"; "<"; ">"; ","; ":"; "."; ".."; "~"; "||"; "="; "!="; "<="; "=>"; "+";
         "-"; "*"; "/"; "p"; "q"; "1"; "0"; "1e9"; "\"x\""; "\""; "/*"; "*/"; "//"; "\n"; "a\xCC\x84";
         "\xCF\x89"; "$"; "1e99999999"; "/0" ])

let soup =
  Gen2.map (String.concat " ") (Gen2.list_size (Gen2.int_range 0 60) fragment)

let mutilated =
  let open Gen2 in
  let* m = Gen.model in
  let text = Printer.model m in
  let* from = int_range 0 (String.length text) in
  let* length = int_range 0 20 in
  let* put = fragment in
  let stop = min (String.length text) (from + length) in
  return (String.sub text 0 from ^ put ^ String.sub text stop (String.length text - stop))

let suite =
  ("syntax properties",
   [
     ("print and parse",
      Scc_test_support.Property.cases
        [
          parse_print_expr 3000 "precedence is kept" Gen.operators;
          parse_print_expr 1000 "parse (print e) = e" Gen.expr;
          parse_print;
          print_idempotent;
          comments_kept;
          comments_idempotent;
        ]);
     ("any text has an answer",
      Scc_test_support.Property.cases
        [ total bytes "any bytes"; total soup "any tokens"; total mutilated "a damaged model" ]);
   ])
