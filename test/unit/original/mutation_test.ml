(* Damaged texts: whatever comes in, the answer is a model or errors with their places. *)

open Scc_base
open Scc_original
module G = QCheck2.Gen

let seed =
  "model dock // ∪ in a comment\ncurved inscribed 1/4\nlet s = 2\n\
   shape Cube = polyhedron((-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, \
   1, 1), \
   (-1, 1, 1))\nregion top on Cube = polygon((-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1))\n\
   region pocket on Cube = top ∩ half((1, 0, 0), 1/s) ∖ point((1, 1, 1))\nshape Ball = sphere(1)\n\
   region pole on Ball = cap((0, 0, -1), 1/2)\ncompound Two { part a : <Ball, 1, (0, 0, 0), (0, 0, 0)>\n\
   part b : Ball mass 1 at translate (0, 0, 2) glue a.north * b.south }\n\
   behaviour E on Cube = <dock, pocket ∪ hull(v1, v2)>. eps(1). omega(dock, pocket) push(1). E\n\
   behaviour L on Ball = <~dock, pole>. rho({<dock, pole>}). nil\n\
   process e = <Cube, 3, (0, 0, 0), (0, 0, 0)> [E]\n\
   process l = l1 : <Ball, 1, (0, 0, 5), (0, 0, -1)> [L] <dock, l1.south * l2.north> l2 : Ball mass 1 \
   velocity (0, 0, -1) \
   at translate (0, 0, 3) [nil]\nfor i in 1..2 if i < s, j in 0..1 { process c[i, j] = <Ball, 1, (9*i, 9*j, \
   0), (0, 0, \
   0)> [nil] }\ncheck c : always x(e) < 3 and bonds(dock) <= 1\n"

let pieces =
  [
    "<"; ">"; "⟨"; "⟩"; ","; "("; ")"; "{"; "}"; "["; "]"; " region "; " on "; " curved "; " glue ";
    " omega("; "∪"; "∩"; "∖"; "*"; "+"; "-"; "/"; "0"; "1e9"; "1/0"; " surface() "; " half("; " cap(";
    " point("; " segment("; "="; " sphere(1) "; " polyhedron("; " interior("; " hull("; "\""; "/*"; "*/";
    "//"; "\n"; "\xE2"; "\xE2\x88"; " only "; " process ";
  ]

type change = Cut of int * int | Put of int * string | Twice of int * int

let change =
  let n = String.length seed in
  let at = G.int_bound (n - 1) and length = G.int_range 1 40 in
  G.oneof
    [
      G.map2 (fun i k -> Cut (i, k)) at length; G.map2 (fun i s -> Put (i, s)) at (G.oneofl pieces);
      G.map2 (fun i k -> Twice (i, k)) at length;
    ]

let apply text change =
  let n = String.length text in
  let clip i = Int.min i n in
  let sub i j = String.sub text (clip i) (clip j - clip i) in
  match change with
  | Cut (i, k) -> sub 0 i ^ sub (i + k) n
  | Put (i, s) -> sub 0 i ^ s ^ sub i n
  | Twice (i, k) -> sub 0 (i + k) ^ sub i n

let text = G.map (List.fold_left apply seed) (G.list_size (G.int_range 1 4) change)

let placed text (d : Diag.t) = Span.is_none d.span || (d.span.start >= 0 && d.span.stop <= String.length text)

let damaged =
  QCheck2.Test.make ~count:750 ~name:"damaged texts are read or refused" ~print:Fun.id text (fun text ->
      let source = Source.make ~name:"model.osc" text in
      ignore (Original.readable source);
      match Original.read source with
      | Error ds -> ds <> [] && List.for_all (placed text) ds
      | Ok read -> (
          ignore (Original.write read);
          match Original.canonical source with
          | Error _ -> QCheck2.Test.fail_report "read, and not written"
          | Ok once -> (
              match Original.canonical (Source.make ~name:"model.osc" once) with
              | Ok twice -> String.equal once twice || QCheck2.Test.fail_report (once ^ "\n---\n" ^ twice)
              | Error ds -> QCheck2.Test.fail_report (once ^ (List.hd ds).message))))

(* Long texts take a time that grows no faster than they do. *)
let long () =
  let n = 20_000 in
  let repeated piece = String.concat "" (List.init n (fun _ -> piece)) in
  List.iter
    (fun text -> ignore (Original.read (Source.make ~name:"model.osc" text)))
    [
      "behaviour A = " ^ repeated "<a, x>. " ^ "nil"; "behaviour A = " ^ repeated "<a, "; repeated "∪";
      "process p = " ^ repeated "<a,"; "compound C { " ^ repeated "glue a ";
      "behaviour A = <a, x" ^ repeated " + x" ^ ">. nil"; repeated "region r on S = x\n";
      "behaviour A = " ^ String.concat " + " (List.init 2_000 (fun _ -> "<a, x>. nil"));
    ]

let suite =
  ("texts of the original notation",
   [
     ("mutations", [ Scc_test_support.Property.case damaged ]); ("long", [ Alcotest.test_case "long texts"
                                                                             `Quick long ]);
   ])
