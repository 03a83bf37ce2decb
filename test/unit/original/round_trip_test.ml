(* From the language to the original notation and back: every model of specs/models, and random trees. *)

open Scc_base
open Scc_syntax
open Scc_test_trees
open Scc_original

let rendered text ds =
  let source name = Some (Source.make ~name text) in
  String.concat "" (List.map (Diag.render ~source) ds)

let get text = function Ok v -> v | Error ds -> Alcotest.fail (rendered text ds)
let source text = Source.make ~name:"model.osc" text

let rec files folder =
  Sys.readdir folder |> Array.to_list |> List.sort String.compare
  |> List.concat_map (fun name ->
      let path = Filename.concat folder name in
      if Sys.is_directory path then files path else if Filename.check_suffix path ".sc" then [ path ] else [])

let contents path =
  let channel = open_in_bin path in
  Fun.protect ~finally:(fun () -> close_in channel) (fun () -> really_input_string channel (in_channel_length
                                                                                              channel))

(* {1 Up to what means nothing}

   The order of attributes, and whether the name of a body is said of each vertex of a tuple or once before
     it. *)

let rank (a : Ast.attribute) =
  match a.it with Mass _ -> 0 | Velocity _ -> 1 | Spin _ -> 2 | Absorb -> 3 | At _ -> 4

let ordered attributes = List.stable_sort (fun a b -> Int.compare (rank a) (rank b)) attributes

let feature (f : Ast.feature) : Ast.feature =
  match f.it with
  | Named _ | Tuple (None, _) -> f
  | Tuple (Some prefix, vs) ->
    { f with it = Tuple (None, List.map (fun (v : Ast.path) -> { v with it = prefix.it @ v.it }) vs) }

let channel (c : Ast.channel) =
  { c with features = List.map (fun (m : Ast.member) -> { m with feature = feature m.feature }) c.features }

let rec item (i : Ast.item) : Ast.item =
  let leaf (l : Ast.leaf) = { l with attributes = ordered l.attributes } in
  let chain rest = List.map (fun (b, l) -> (b, leaf l)) rest in
  let i = Walk.item { Walk.same with channel; feature } i in
  let it : Ast.item_kind =
    match i.it with
    | Process (s, l, rest) -> Process (s, leaf l, chain rest)
    | Fixed (s, l, rest) -> Fixed (s, leaf l, chain rest)
    | Compound (h, parts, glues, ds) ->
      let part (p : Ast.part) = { p with part_attributes = ordered p.part_attributes } in
      Compound (h, List.map part parts, glues, ds)
    | For (ranges, body) -> For (ranges, List.map item body)
    | other -> other
  in
  { i with it }

let same a b = Ast_equal.model (List.map item a) (List.map item b)

(* {1 Models} *)

let kept text =
  let model, trivia = get text (Parse.with_trivia (Source.make ~name:"model.sc" text)) in
  let original = get text (Original.write (model, trivia)) in
  let model', trivia' = get original (Original.read (source original)) in
  if not (same model model') then
    Alcotest.(check string) "the model" (Printer.model model) (Printer.model model');
  let comments ts = List.length (List.filter Trivia.is_comment ts) in
  Alcotest.(check int) "comments" (comments trivia) (comments trivia');
  Alcotest.(check string) "canonical" original (get original (Original.canonical (source original)))

let models () =
  let all = files "../../../specs/models" in
  Alcotest.(check bool) "there are models" true (List.length all > 60);
  List.iter (fun path -> kept (contents path)) all

(* What each part of the notation says. *)
let says () =
  let check text expected =
    let model, _ = get text (Original.read (source text)) in
    Alcotest.(check string) text expected (Printer.model model)
  in
  check "process p = <box(2, 2, 2), 3, (1, 0, 0), (0, 1, 0)> [<a, top ∪ hull(a, b)>. nil]"
    "process p = box(2, 2, 2) mass 3 velocity (0, 1, 0) at translate (1, 0, 0) [<a, {top, [a, b]}>. nil]\n";
  check "behaviour K(x) = ⟨ā, interior(top) + x⟩·ω(a, empty()) push(1).nil + ρ({⟨a, top⟩, <b, q.f>}).K(x)"
    "behaviour K(x) =\n\
    \  <~a, {only top, x}>. omega(a, {}) push(1). nil\n\
    \  + rho({<a, {top}>, <b, {q.f}>}). K(x)\n";
  check "bond <a, p[1].right ∩ q.left.top>" "bond <a, {p[1].right, q.left.top}>\n";
  check "compound C { part a : box(1,1,1) mass 1 part b : <box(1,1,1), 1, (0,0,1), (0,0,0)> glue \
         a.top*b.bottom }"
    "compound C {\n\
    \  part a : box(1, 1, 1) mass 1\n\
    \  part b : box(1, 1, 1) mass 1 velocity (0, 0, 0) at translate (0, 0, 1)\n\
    \  glue a.top ~ b.bottom\n\
     }\n";
  check "shape T(s) = polyhedron((0,0,0), (s,0,0), (0,s,0), (0,0,s))\nregion o on T = point((0,0,0))\n\
         region x on T = polygon((0,0,0), (0,s,0), (s,0,0))"
    "shape T(s) {\n\
    \  vertices o (0, 0, 0)  v1 (s, 0, 0)  v2 (0, s, 0)  v3 (0, 0, s)\n\
    \  faces    x [o, v2, v1]\n\
     }\n";
  check "shape T = polyhedron((0,0,0), (2,0,0), (0,2,0), (0,0,2), (1/2,1/2,1/2))\n\
         region slope on T = polygon((0,2,0), (2,0,0), (0,0,2))"
    "shape T {\n\
    \  vertices v1 (0, 0, 0)  v2 (2, 0, 0)  v3 (0, 2, 0)  v4 (0, 0, 2)\n\
    \  faces    slope [v4, v2, v3]  f1 [v1, v3, v2]  f2 [v1, v2, v4]  f3 [v1, v4, v3]\n\
     }\n";
  check "let s = 2\nprocess p = box(s, s, s) mass 1 [nil] // s < 3, ∪ and <a, b>\ncheck c : always x(p) < 3"
    "let s = 2\nprocess p = box(s, s, s) mass 1 [nil]\ncheck c : always x(p) < 3\n"

let random =
  QCheck2.Test.make ~count:150 ~name:"read (write m) = m" ~print:Printer.model Gen.model (fun m ->
      (* Random vertices and faces are of no solid: such a shape has no set of points. *)
      let rec solid (i : Ast.item) =
        match i.it with
        | Shape (_, { it = Faces _; _ }, _) -> false
        | For (_, body) -> List.for_all solid body
        | _ -> true
      in
      let m = List.filter solid m in
      match Original.write (m, []) with
      | Error ds -> List.for_all (fun (d : Diag.t) -> String.equal d.code "SC0360") ds
      | Ok text when String.trim text = "" -> true
      | Ok text -> (
          match Original.read (source text) with
          | Ok (m', _) -> same m m' || QCheck2.Test.fail_report text
          | Error ds -> QCheck2.Test.fail_report (text ^ rendered text ds)))

let suite =
  ("the original notation",
   [
     ( "round trips",
       [
         Alcotest.test_case "Regions: every model" `Quick models;
         Alcotest.test_case "Regions: what each part of the notation says" `Quick says;
         Scc_test_support.Property.case random;
       ] );
   ])
