(* Times linear casts and contact tests on a data set of test/data/geometry:

     geometry.exe SHAPE PAIRS             nanoseconds for each query, and ratios within this run
     geometry.exe SHAPE PAIRS --answers   the answers to the casts instead, as in an answer file

   'fresh' makes the obstacle for the one query, 'cached' has it already, 'naive' tries
   all separating axes over rationals (on the first few pairs only). *)

open Scc_exact
open Scc_geometry
module Data = Scc_test_data.Test_data
module Naive = Scc_naive.Naive

(* Keeps the results alive. *)
let sink = ref 0

let count_cast = function Obstacle.At _ -> incr sink | Never | Inside -> ()
let count_relation r = if r = Obstacle.Touching then incr sink

(* Processor time for each of [n] calls of [f], over as many rounds as take half a second, in nanoseconds. *)
let nanoseconds n f =
  let start = Sys.time () in
  let rec rounds k =
    for i = 0 to n - 1 do
      f i
    done;
    let elapsed = Sys.time () -. start in
    if elapsed < 0.5 then rounds (k + 1) else elapsed *. 1e9 /. float_of_int (k * n)
  in
  rounds 1

let print_answers a cases =
  Array.iter
    (fun (c : Data.case) ->
       let b = Solid.make ~id:1 a.Solid.polyhedron c.turn in
       print_endline (Data.answer (Obstacle.make a b) c.far c.velocity))
    cases

let measure plain (a : Solid.t) (cases : Data.case array) =
  let n = Array.length cases in
  let solids = Array.map (fun (c : Data.case) -> Solid.make ~id:1 a.polyhedron c.turn) cases in
  let obstacles = Array.map (Obstacle.make a) solids in
  let cast o i = count_cast (Obstacle.first_time_of_contact o cases.(i).far cases.(i).velocity) in
  let contact o i = count_relation (Obstacle.relation o cases.(i).near) in
  let made = nanoseconds n (fun i -> sink := !sink + Array.length (Obstacle.make a solids.(i)).facets) in
  let facets = Array.fold_left (fun s (o : Obstacle.t) -> s + Array.length o.facets) 0 obstacles in
  Printf.printf "%d pairs, %.1f facets for each obstacle, made in %.0f ns\n" n
    (float_of_int facets /. float_of_int n) made;
  let few = Int.min n (Int.max 1 (200_000 / (Array.length a.normals * Array.length a.normals * 100))) in
  let b_at i at = Naive.move cases.(i).turn at plain in
  let row name cached fresh naive =
    Printf.printf "%-8s cached %9.0f ns   fresh %9.0f ns (x %.1f)   naive %11.0f ns (x %.0f)\n%!" name
      cached fresh (fresh /. cached) naive (naive /. cached)
  in
  row "cast"
    (nanoseconds n (fun i -> cast obstacles.(i) i))
    (nanoseconds n (fun i -> cast (Obstacle.make a solids.(i)) i))
    (nanoseconds few (fun i ->
         match Naive.first_time_of_contact plain (b_at i cases.(i).far) cases.(i).velocity with
         | At _ -> incr sink
         | Never | Inside -> ()));
  row "contact"
    (nanoseconds n (fun i -> contact obstacles.(i) i))
    (nanoseconds n (fun i -> contact (Obstacle.make a solids.(i)) i))
    (nanoseconds few (fun i -> if Naive.relation plain (b_at i cases.(i).near) = Touching then incr sink))

let () =
  match Array.to_list Sys.argv with
  | _ :: shape :: pairs :: options when options = [] || options = [ "--answers" ] ->
    let plain = Data.shape shape in
    let a = Data.solid ~id:0 plain Mat.identity in
    let cases = Data.pairs pairs in
    if options = [] then measure plain a cases else print_answers a cases
  | _ ->
    prerr_endline "usage: geometry.exe SHAPE PAIRS [--answers]";
    exit 2
