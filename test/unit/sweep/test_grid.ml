(* The values of parameters that a sweep goes through: as they are written, and in which order. *)

open Scc_exact
open Scc_sweep
open Scc_test_support

let texts values = Array.to_list (Array.map Rat.to_string values)

let written () =
  let is text expected =
    match Grid.values text with
    | Ok values -> Alcotest.(check (list string)) text expected (texts values)
    | Error why -> Alcotest.failf "%s: %s" text why
  in
  is "3" [ "3" ];
  is "-1/2" [ "-1/2" ];
  is "1, 0.5,1/3" [ "1"; "1/2"; "1/3" ];
  is "1..4" [ "1"; "2"; "3"; "4" ];
  is "-1..1" [ "-1"; "0"; "1" ];
  is "1/2..2" [ "1/2"; "3/2" ];
  is "0:1:1/4" [ "0"; "1/4"; "1/2"; "3/4"; "1" ];
  is "0:1:2/5" [ "0"; "2/5"; "4/5" ];
  is "2:2:7" [ "2" ]

let refused () =
  let is text expected =
    match Grid.values text with
    | Ok values -> Alcotest.failf "%s: %s" text (String.concat " " (texts values))
    | Error why -> Alcotest.(check string) text expected why
  in
  is "" "`' is no number";
  is "a" "`a' is no number";
  is "1,,2" "`' is no number";
  is "1,2,1.0" "`1.0' is there twice";
  is "4..1" "`4..1' ends before it begins";
  is "0:1:0" "`0:1:0' has no positive step";
  is "0:1:-1" "`0:1:-1' has no positive step";
  is "0:1" "`0:1' is neither a value, nor a list 1,2,5, nor 1..10, nor 0:2:1/8";
  is "1..1000000000" "`1..1000000000' has 1000000000 values: at most 1000000";
  is "0:1:1e-300" ("`0:1:1e-300' has 1" ^ String.make 299 '0' ^ "1 values: at most 1000000")

(* By loops in each other, the last axis innermost. *)
let rec all : Grid.t -> (string * Rat.t) list list = function
  | [] -> [ [] ]
  | a :: rest ->
    List.concat_map
      (fun r -> List.map (fun others -> (a.name, r) :: others) (all rest))
      (Array.to_list a.values)

let points =
  QCheck2.Test.make ~name:"points" ~count:200
    ~print:(fun l -> String.concat " " (List.map string_of_int l))
    QCheck2.Gen.(list_size (int_range 1 4) (int_range 1 4))
    (fun sizes ->
       let axis i n = { Grid.name = string_of_int i; values = Array.init n (fun k -> Rat.of_int (k * k)) } in
       let grid = List.mapi axis sizes in
       let count = Z.to_int (Grid.size grid) in
       let same (a, r) (b, s) = String.equal a b && Rat.equal r s in
       List.equal (List.equal same) (all grid) (List.init count (Grid.point grid)))

(* A map without rows or columns is its title, and so is a panel without points. *)
let empty_charts () =
  let open Scc_svg in
  let map rows columns : Chart.map =
    let cell _ = { Chart.said = "here"; amount = Amount Rat.one } in
    { title = "empty"; rows = Array.make rows "r"; columns = Array.make columns "c";
      cells = Array.init rows (fun _ -> Array.init columns cell) }
  in
  let drawn panels maps =
    let text = Chart.sheet ~title:"t" ~caption:"c" ~x:"x" ~named:[] panels maps in
    Alcotest.(check string) "whole" "</svg>\n" (String.sub text (String.length text - 7) 7)
  in
  List.iter (fun (rows, columns) -> drawn [] [ map rows columns ]) [ (0, 0); (0, 2); (2, 0); (1, 1) ];
  drawn [ { title = "p"; curves = [] } ] [];
  drawn [ { title = "p"; curves = [ { name = "n"; pieces = [ [] ] } ] } ] []

(* One warning at most, where a chosen kick is first another than at the first point. *)
let kicks () =
  let lattice ?(chosen = true) ?(name = "p") kick =
    let lattice = { Scc_elaborate.Diffusion.kick = Rat.of_int kick; spread = Rat.one; chosen; spin = None } in
    Scc_elaborate.Lattices.of_bodies [ (name, lattice, Scc_base.Span.none) ]
  in
  let check what expected ?(first = lattice 2) points =
    let t = Kicks.start first in
    let warned = List.filteri (fun k l -> Option.is_some (Kicks.add t k l)) points in
    let end_ = Option.value (Kicks.conclusion t) ~default:"" in
    Alcotest.(check (pair int string)) what expected (List.length warned, end_)
  in
  let changed low high =
    Printf.sprintf "scc: the kicks chosen for diffuse are from %d to %d: h = %d is long enough at all points" low
      high high
  in
  check "the same" (0, "") [ lattice 2; lattice 2 ];
  check "longer" (1, changed 2 8) [ lattice 2; lattice 4; lattice 8; lattice 2 ];
  check "shorter" (1, changed 1 2) [ lattice 2; lattice 1 ];
  check "given" (0, "") ~first:(lattice ~chosen:false 2) [ lattice ~chosen:false 2; lattice ~chosen:false 4 ];
  check "of another body" (0, "") [ lattice 2; lattice ~name:"q" 4 ];
  check "an invalid point" (1, changed 2 4) [ lattice 2; []; lattice 4 ];
  check "an invalid first point" (1, changed 2 4) ~first:[] [ []; lattice 2; lattice 4 ]

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "grid"
    [
      ("values", [ case "as they are written" written; case "what is none" refused ]);
      ("points", Property.cases [ points ]);
      ("kicks", [ case "Diffuse: kicks over a sweep" kicks ]);
      ("charts", [ case "of nothing" empty_charts ]);
    ]
