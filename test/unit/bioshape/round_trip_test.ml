(* What is written as XML is read back as it was: every model of specs/models, and random trees. *)

open Scc_base
open Scc_syntax
open Scc_test_trees
open Scc_bioshape
module Gen2 = QCheck2.Gen

let rendered text ds =
  let source name = Some (Source.make ~name text) in
  String.concat "" (List.map (Diag.render ~source) ds)

let get text = function Ok v -> v | Error ds -> Alcotest.fail (rendered text ds)
let xml ?trivia model = get "" (Write.model ?trivia model)
let read text = get text (Read.with_trivia (Source.make ~name:"model.xml" text))

(* {1 The models} *)

let rec files folder =
  Sys.readdir folder |> Array.to_list |> List.sort String.compare
  |> List.concat_map (fun name ->
      let path = Filename.concat folder name in
      if Sys.is_directory path then files path else if Filename.check_suffix path ".sc" then [ path ] else [])

let contents path =
  let channel = open_in_bin path in
  let read () = really_input_string channel (in_channel_length channel) in
  Fun.protect ~finally:(fun () -> close_in channel) read

(* The canonical print with its comments; and the document is canonical itself. *)
let kept text =
  let model, trivia = get text (Parse.with_trivia (Source.make ~name:"model.sc" text)) in
  let document = xml ~trivia model in
  let model', trivia' = read document in
  let printed = Printer.model ~trivia model in
  Alcotest.(check string) "the canonical print" printed (Printer.model ~trivia:trivia' model');
  Alcotest.(check bool) "the tree" true (Ast_equal.model model model');
  Alcotest.(check string) "the document, written again" document (xml ~trivia:trivia' model')

let models () =
  let all = files "../../../specs/models" in
  Alcotest.(check bool) "there are models" true (List.length all > 60);
  List.iter
    (fun path ->
       let text = contents path in
       match Parse.parse (Source.make ~name:path text) with Ok _ -> kept text | Error _ -> ())
    all

(* {1 Random trees} *)

let random =
  QCheck2.Test.make ~count:120 ~name:"read (write m) = m" ~print:Printer.model Gen.model (fun m ->
      match Write.model m with
      | Error ds -> QCheck2.Test.fail_report (rendered "" ds)
      | Ok text -> (
          match Read.with_trivia (Source.make ~name:"model.xml" text) with
          | Ok (m', _) -> Ast_equal.model m m' || QCheck2.Test.fail_report text
          | Error ds -> QCheck2.Test.fail_report (text ^ rendered text ds)))

(* In XML an expression stands alone wherever it is, and may be one that the grammar of the language has in
   brackets only there: what is printed has them. *)

let expressions =
  [
    "value"; "by"; "from"; "to"; "above"; "below"; "if"; "x"; "point"; "time"; "push"; "weight"; "velocity";
    "snap"; "grid";
  ]

let with_expressions (text, those) =
  let b = Buffer.create (String.length text) and left = ref those in
  let n = String.length text in
  (* The value of a setting is a word, and no expression. *)
  let word i =
    let tag = String.rindex_from text i '<' in
    List.exists
      (fun s -> String.equal s (String.sub text (tag + 1) (min (String.length s) (n - tag - 1))))
      [ "dynamics"; "collisions"; "binding"; "bonds" ]
  in
  let rec go i =
    if i < n then
      match if text.[i] = ' ' then String.index_from_opt text i '=' else None with
      | Some j when List.mem (String.sub text (i + 1) (j - i - 1)) expressions && text.[j + 1] = '"' ->
        let close = String.index_from text (j + 2) '"' in
        let old = String.sub text (j + 2) (close - j - 2) in
        let value =
          match !left with
          | e :: rest when not (word i) ->
            left := rest @ [ e ];
            Escaped.attribute (Printer.expr e)
          | _ -> "\"" ^ old ^ "\""
        in
        Buffer.add_string b (String.sub text i (j - i + 1) ^ value);
        go (close + 1)
      | _ ->
        Buffer.add_char b text.[i];
        go (i + 1)
  in
  go 0;
  Buffer.contents b

let contexts =
  let document = Gen2.map (fun m -> get "" (Write.model m)) Gen.model in
  let gen = Gen2.pair document (Gen2.list_size (Gen2.return 7) Gen.expr) in
  QCheck2.Test.make ~count:40 ~name:"expressions in places of their own" ~print:with_expressions gen (fun given ->
      let text = with_expressions given in
      match Read.with_trivia (Source.make ~name:"model.xml" text) with
      | Error ds -> QCheck2.Test.fail_report (rendered text ds)
      | Ok (m, _) -> (
          let printed = Printer.model m in
          match Parse.parse (Source.make ~name:"model.sc" printed) with
          | Ok m' -> Ast_equal.model m m' || QCheck2.Test.fail_report ("another tree\n" ^ printed)
          | Error ds -> QCheck2.Test.fail_report (rendered printed ds)))

(* {1 Comments} *)

let comments =
  [
    ("dashes", "// -- a --- b -\nprocess p = Cube [nil] /* - -- */\n");
    ("backslashes between dashes", "// -\\- -\\\\-- -\\a-\\\nprocess p = Cube [nil]\n");
    ("several lines", "/* one\n   two <three> & four -- */\nprocess p = Cube [nil] // after\n\n// at the end\n");
    ("an empty one", "//\nprocess p = Cube [nil]\n");
    ("inside", "compound C {\n  part a : Cube mass 1 // the first\n  // before the glue\n  glue a.l ~ a.r\n}\n");
    ("empty lines",
     "param a = 1\n\n\nparam b = 2\nparam c = 3\n\nfor i in 1..2 {\n  let x = 1\n\n  let y = 2\n}\n");
  ]

let kept_comment text () =
  let model, trivia = get text (Parse.with_trivia (Source.make ~name:"model.sc" text)) in
  let _, trivia' = read (xml ~trivia model) in
  let texts t = List.filter_map (fun (c : Trivia.t) -> if Trivia.is_comment c then Some c.text else None) t in
  let marks s = if String.length s > 3 && s.[1] = '*' then 4 else 2 in
  let bare s = String.trim (String.sub s 2 (String.length s - marks s)) in
  Alcotest.(check (list string)) text (List.map bare (texts trivia)) (List.map bare (texts trivia'))

let comment (name, text) = Alcotest.test_case name `Quick (kept_comment text)

(* {1 What other programs write} *)

let same_as name document text =
  let test () =
    let model, _ = read document in
    Alcotest.(check string) document text (Printer.model model)
  in
  Alcotest.test_case name `Quick test

let around s = Printf.sprintf "<bioshape xmlns='%s'>%s</bioshape>" Namespace.uri s

let foreign =
  [
    same_as "a prefix, apostrophes, marked sections, references, comments within a text"
      (Printf.sprintf
         "\xEF\xBB\xBF<?xml version='1.0' encoding='utf-8' standalone='yes'?>\r\n\
          <?go on?><b:bioshape xmlns:b='%s'\r\n>\
          <b:check name='&#99;'>al<!-- in -->ways <![CDATA[x(p) < 3]]> and &#x79;(p) &lt; 4<?and so?></b:check >\
          </b:bioshape><!-- after -->\n"
         Namespace.uri)
      "check c : always x(p) < 3 and y(p) < 4\n";
    same_as "where a schema is" 
      (Printf.sprintf
         "<bioshape xmlns='%s' xmlns:i='http://www.w3.org/2001/XMLSchema-instance' i:schemaLocation='a b'>\
          <let name='x' value='1'/></bioshape>" Namespace.uri)
      "let x = 1\n";
    same_as "spaces, tabs and line ends in attributes"
      (around "<import file=' a  b.sc' /><shape name=' S ' parameters='\n a\tb '><template name=' T '/></shape>")
      "import \" a  b.sc\"\nshape S(a, b) = T\n";
    same_as "quotes in the name of a file" (around "<import file='a&quot;\\b&#9;'/>") "import \"a\\\"\\\\b\t\"\n";
    same_as "summands in brackets on either side"
      (around
         "<behaviour name='K'><choice><branch><choice><branch><call name='A'/></branch><branch><nil/></branch>\
          </choice></branch><branch><delay time='1'/><choice><branch><nil/></branch><branch><call name='m.B(2)'/>\
          </branch></choice></branch></choice></behaviour>")
      "behaviour K = A + nil + eps(1). (nil + m.B(2))\n";
  ]

(* {1 Size} *)

let deep () =
  let prefixes = String.concat "" (List.init 9_000 (fun _ -> "eps(1). ")) in
  kept ("behaviour K = " ^ prefixes ^ "nil\n");
  let rec nested n = if n = 0 then "nil" else "nil + (" ^ nested (n - 1) ^ ")" in
  kept ("behaviour K = " ^ nested 990 ^ "\n");
  let scaled = String.concat "" (List.init 5_000 (fun _ -> " scaled (1, 1, 1)")) in
  kept ("shape S = T" ^ scaled ^ "\n")

let large () =
  let vertices = String.concat " " (List.init 20_000 (Printf.sprintf "v%d (0, 0, 0)")) in
  let text = "shape S = hull { " ^ vertices ^ " }\n" in
  let model = get text (Parse.parse (Source.make ~name:"model.sc" text)) in
  Alcotest.(check bool) "the tree" true (Ast_equal.model model (fst (read (xml model))))

let suite =
  let quick name f = Alcotest.test_case name `Quick f in
  ("models in XML",
   [
     ("models", [ quick "every model of specs/models" models ]);
     ("random", Scc_test_support.Property.cases [ random; contexts ]);
     ("comments", List.map comment comments);
     ("others", foreign);
     ("size", [ quick "deep" deep; quick "large" large ]);
   ])
