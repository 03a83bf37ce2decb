(* Canonical layout of parts: in models whose spaces, line ends and comments were changed at random, the part is
   what the whole text in canonical layout has there, and the rest stays. SCC_TIMES=n makes it n times as long. *)

open Scc_base
open Scc_syntax
open Scc_notation
open Scc_assist
open Texts

let formatted text ~from ~upto =
  match Formatting.within (Source.make ~name:"m.sc" text) ~from ~upto with
  | Error _ -> Alcotest.failf "errors in %s" text
  | Ok None -> text
  | Ok (Some e) -> String.sub text 0 e.start ^ e.put ^ String.sub text e.stop (String.length text - e.stop)

let becomes text piece wanted () =
  let from = place text piece in
  let found = formatted text ~from ~upto:(from + String.length piece) in
  Alcotest.(check string) piece wanted found

let by_hand =
  [
    case "one declaration" (becomes "let  a=1\nlet  b=2\nlet  c=3\n" "b" "let  a=1\nlet b = 2\nlet  c=3\n");
    case "what shares its line" (becomes "let  a=1 let  b=2\nlet  c=3\n" "b" "let a = 1\nlet b = 2\nlet  c=3\n");
    case "a comment behind it" (becomes "let  a=1   // one\nlet  b=2\n" "a" "let a = 1 // one\nlet  b=2\n");
    case "a comment that moves out"
      (becomes "let  a=1\nlet b = // two\n  2\nlet  c=3\n" "b" "let  a=1\nlet b = // two\n  2\nlet  c=3\n");
    case "a comment before it" (becomes "/* a */ let  a=1\nlet  b=2\n" "a=" "/* a */\nlet a = 1\nlet  b=2\n");
    case "in a loop"
      (becomes "for i in 1..2{let a=1}\nlet  b=2\n" "a=" "for i in 1..2 { let a = 1 }\nlet  b=2\n");
    case "spaces before it" (becomes "let  a=1\n   let  b=2\n" "b" "let  a=1\nlet b = 2\n");
    case "nothing touched"
      (becomes "let  a=1\n// x\n\n// y\nlet  b=2\n" "// x" "let  a=1\n// x\n\n// y\nlet  b=2\n");
    case "other line ends"
      (becomes "let  a=1\r\nlet  b=2\r\nlet  c=3\r\n" "b" "let  a=1\r\nlet b = 2\r\nlet  c=3\r\n");
  ]

(* {1 At random} *)

(* The same tokens with other things between them. *)
let deformed state text =
  let tokens = (Lazy.force (reading text).tokens).tokens in
  let b = Buffer.create (String.length text) in
  let pick list = List.nth list (Random.State.int state (List.length list)) in
  let between gap =
    if Random.State.int state 12 > 0 then gap
    else gap ^ pick [ "\n"; "  "; "\t\n\n"; " /* c */ "; " // d\n"; "\r\n"; "/* e\n f */" ]
  in
  let is_end gap = gap <> "" && String.for_all (fun c -> c = '\n') gap in
  let glue gap = if is_end gap && Random.State.int state 8 = 0 then " " else gap in
  let add at (t : Tokens.token) =
    Buffer.add_string b (between (glue (String.sub text at (t.start - at))));
    Buffer.add_string b (String.sub text t.start (t.stop - t.start));
    t.stop
  in
  ignore (Array.fold_left add 0 tokens);
  Buffer.contents b

let canonical file text = Notation.canonical (Source.make ~name:file text)

(* Whether a text is a piece of another. *)
let is_within whole piece =
  let n = String.length whole and m = String.length piece in
  let rec from i = i + m <= n && (String.sub whole i m = piece || from (i + 1)) in
  from 0

let count = ref 0
let narrow = ref 0

let one state file text =
  let n = String.length text in
  match canonical file text with
  | Error _ -> ()
  | Ok after -> (
      let a = Random.State.int state (n + 1) in
      let b = if Random.State.int state 3 = 0 then a else Int.min n (a + Random.State.int state 400) in
      match Formatting.within (Source.make ~name:file text) ~from:a ~upto:b with
      | Error _ -> Alcotest.failf "%s: errors" file
      | Ok None -> ()
      | Ok (Some e) ->
        incr count;
        if 2 * (e.stop - e.start) < n then incr narrow;
        let fail what = Alcotest.failf "%s, %d to %d, %s:\n%s" file a b what text in
        if not (is_within after e.put) then fail "not a part of the whole";
        let result = String.sub text 0 e.start ^ e.put ^ String.sub text e.stop (n - e.stop) in
        (match canonical file result with
         | Ok again when again = after -> ()
         | Ok again -> fail (Printf.sprintf "another layout of the whole:\n%s\n---\n%s\n---" after again)
         | Error _ -> fail ("errors in " ^ result));
        (* again it changes nothing *)
        let upto = e.start + String.length e.put in
        let first = Int.min upto (Int.max a e.start) in
        let changes (e : Formatting.edit) = String.sub result e.start (e.stop - e.start) <> e.put in
        match Formatting.within (Source.make ~name:file result) ~from:first ~upto:first with
        | Ok (Some e) when changes e && first < upto -> fail "not fixed"
        | _ -> ())

let all () =
  let rec files folder =
    let entry name =
      let path = Filename.concat folder name in
      if Sys.is_directory path then files path
      else if List.exists (Filename.check_suffix name) [ ".sc"; ".osc"; ".xml" ] then [ path ]
      else []
    in
    List.concat_map entry (List.sort String.compare (Array.to_list (Sys.readdir folder)))
  in
  files "../../../specs"

let at_random () =
  let seed = Option.value (Option.bind (Sys.getenv_opt "SCC_SEED") int_of_string_opt) ~default:1 in
  let rounds = Option.value (Option.bind (Sys.getenv_opt "SCC_TIMES") int_of_string_opt) ~default:1 in
  let state = Random.State.make [| seed |] in
  let model path =
    let text = read path in
    if String.length text < 100_000 then
      for _ = 1 to rounds do
        one state path text;
        if Filename.check_suffix path ".sc" then one state path (deformed state text)
      done
  in
  List.iter model (all ());
  Printf.printf "%d parts, %d of them less than half\n" !count !narrow;
  Alcotest.(check bool) (Printf.sprintf "%d parts, %d of them less than half" !count !narrow) true (!narrow > 50)

let () =
  Alcotest.run "layout of parts" [ ("by hand", by_hand); ("at random", [ case "all models" at_random ]) ]
