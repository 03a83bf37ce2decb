(* The language reference against the language: its examples are read, its lists are the program's. *)

open Scc_syntax
open Scc_test_trees

let reference =
  let channel = open_in_bin "../../../specs/language.md" in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

(* The blocks between ```tag and ```. *)
let blocks tag =
  let rec outside acc = function
    | [] -> List.rev acc
    | line :: rest when String.equal line ("```" ^ tag) -> inside acc [] rest
    | _ :: rest -> outside acc rest
  and inside acc block = function
    | "```" :: rest -> outside (String.concat "\n" (List.rev block) :: acc) rest
    | line :: rest -> inside acc (line :: block) rest
    | [] -> Alcotest.fail "a block is not closed"
  in
  outside [] (String.split_on_char '\n' reference)

let examples =
  List.mapi
    (fun i text ->
       Alcotest.test_case (Printf.sprintf "example %d" (i + 1)) `Quick (fun () ->
           let m = Support.parsed text in
           Alcotest.(check bool) "printed and read" true
             (Ast_equal.model m (Support.parsed (Printer.model m)))))
    (blocks "sc")

let words () =
  let listed =
    List.concat_map (fun b -> String.split_on_char ' ' (String.concat " " (String.split_on_char '\n' b)))
      (blocks "words")
  in
  Alcotest.(check (list string)) "words" (List.map fst Lexer.words) (List.sort String.compare listed)

(* A face can be declared, and named in a channel, if its name is not reserved. *)
let names_of_faces () =
  let reads word =
    let text =
      Printf.sprintf
        "shape S { vertices v (0, 0, 0) faces %s [v, v, v] f [v, v, v] }\nbehaviour B on S = <a, {%s}>. nil\n"
        word word
    in
    Result.is_ok (Parse.parse (Scc_base.Source.make ~name:"t.sc" text))
  in
  let check (word, _) =
    Alcotest.(check bool) word (reads word) (not (Scc_base.Language_words.is_reserved word))
  in
  List.iter check Lexer.words

let says what () = if not (Support.contains reference what) then Alcotest.failf "`%s` is not told" what

let grouped n =
  if n >= 1_000 then Printf.sprintf "%d %03d" (n / 1_000) (n mod 1_000) else string_of_int n

let limits =
  List.map
    (fun (name, n) -> Alcotest.test_case name `Quick (says ("| " ^ grouped n ^ " |")))
    [
      ("brackets", Tokens.max_nesting); ("depth", Tokens.max_depth); ("digits", Scc_exact.Rat.max_digits);
      ("errors", Parse.max_errors);
    ]

(* Each pair of neighbours of the table of operators, the looser first. *)
let precedence =
  let binary_pairs =
    [
      ("a => b or c", "a => (b or c)"); ("a or b and c", "a or (b and c)"); ("not a and b", "(not a) and b");
      ("not a = b", "not (a = b)"); ("a = b + c", "a = (b + c)"); ("a + b * c", "a + (b * c)");
      ("a * -b", "a * (-b)"); ("always a => b", "always (a => b)"); ("AG a => b", "(AG a) => b");
      ("a => b => c", "a => (b => c)"); ("a leads_to b => c", "a leads_to (b => c)");
      ("a => b leads_to c", "(a => b) leads_to c"); ("always a leads_to b", "always (a leads_to b)");
      ("not event bind(a) = b", "not (event bind(a) = b)");
      ("possibly a leads_to b within 5", "possibly (a leads_to b within 5)");
      ("possibly a leads_to[1, 2] b within 5", "possibly (a leads_to[1, 2] b) within 5");
      ("a leads_to possibly b within 5", "a leads_to (possibly b within 5)");
    ]
  in
  List.map
    (fun (a, b) ->
       Alcotest.test_case a `Quick (fun () ->
           Alcotest.(check bool) b true
             (Ast_equal.expr (Support.parsed_expr a) (Support.parsed_expr b))))
    binary_pairs

let suite =
  ("language reference",
   [
     ("examples", examples);
     ( "words",
       [
         Alcotest.test_case "the list of words" `Quick words;
         Alcotest.test_case "names of faces" `Quick names_of_faces;
       ] );
     ("limits", limits);
     ("precedence", precedence);
   ])
