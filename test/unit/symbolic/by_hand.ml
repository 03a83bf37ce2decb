(* Models in the surface language with the sets of parameters for which their checks hold, as worked out by hand.
*)

open Scc_exact
open Scc_polyhedra
open Scc_symbolic
open Scc_verify
open Scc_regions
open Scc_zones
module Loaded = Scc_loading.Loaded

(* {1 Models} *)

let shapes =
  {|shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
|}

let refuse ds = Alcotest.fail (String.concat "\n" (List.map (fun (d : Scc_base.Diag.t) -> d.message) ds))

let load text =
  let source = Scc_base.Source.make ~name:"case.sc" ("model case\n" ^ shapes ^ text) in
  match Loaded.load ~read_file:(fun _ -> Error "no file") ~overrides:[] source with
  | Ok l -> l
  | Error ds -> refuse ds

let where text =
  let l = load text in
  if Zone_check.refused l.model Zones <> [] then Alcotest.fail "refused";
  let u = match l.uncertain with Some u -> u | None -> Start.known l.model l.declared in
  match Zone_check.run Setup.default l.semantics u ~declared:l.declared ~exactly:true ~premises:[] l.checks with
  | Ok report -> List.map2 (fun (c : Scc_property.Property.check) w -> (c.name, w)) l.checks report.where
  | Error _ -> Alcotest.fail "the start is not well-formed"

(* {1 Sets}

   By their pieces, each a list of constraints; over the parameters in the order of the text. *)

type side = { a : Rat.t list; b : Rat.t }

let q n d = Rat.make (Z.of_int n) (Z.of_int d)
let int = Rat.of_int

(* n0 x0 + n1 x1 + ... + c *)
let form ns c = { a = List.map int ns; b = c }
let linear { a; b } = Linear.make ~constant:b (Array.of_list a)
let zero n = Linear.constant n Rat.zero
let positive ns c =
  let f = linear (form ns c) in
  Constraint.greater f (zero (Linear.dimension f))
let at_least_0 ns c =
  let f = linear (form ns c) in
  Constraint.at_least f (zero (Linear.dimension f))
let is_0 ns c =
  let f = linear (form ns c) in
  Constraint.equals f (zero (Linear.dimension f))

(* |n . x| < c, and <= c *)
let within ns c = [ positive ns c; positive (List.map Int.neg ns) c ]
let within_or_at ns c = [ at_least_0 ns c; at_least_0 (List.map Int.neg ns) c ]

(* x in [from, to), of the one parameter *)
let from_to ~low ~high = [ at_least_0 [ 1 ] (Rat.neg low); positive [ -1 ] high ]

type expected = { name : string; holds : Constraint.t list list; probability : Rat.t }

let holds name holds probability = { name; holds; probability }
let everywhere name = holds name [ [] ] Rat.one
let nowhere name = holds name [] Rat.zero

let agrees all e =
  let w = List.assoc e.name all in
  let n = Array.length w.Where.ranges in
  let box = Union.of_polyhedron (Scc_calculus.Ranges.box w.ranges) in
  let wanted = Union.of_polyhedra n (List.map (Polyhedron.of_constraints n) e.holds) in
  let name = e.name in
  let text = Where_samples.Samples.text w in
  Alcotest.(check (list string)) (name ^ ": parted") [] (Where_samples.Samples.faults w);
  if not (Union.equal w.holds (Union.inter wanted box)) then
    Alcotest.failf "%s holds where %s; by hand where %s" name (text w.holds) (text wanted);
  Alcotest.(check bool) (name ^ ": all is known") true (Union.is_empty w.unknown);
  match Where.probability w with
  | Exactly p -> Alcotest.(check string) (name ^ ": probability") (Rat.to_string e.probability) (Rat.to_string p)
  | Between _ | Not_computed -> Alcotest.failf "%s: its probability is not known" name

let case title text expected =
  let run () =
    let all = where text in
    List.iter (agrees all) expected
  in
  Alcotest.test_case title `Quick run
