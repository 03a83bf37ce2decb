(* Times linear casts and contact tests on pairs of solids, in the formats of test/data/geometry:

     geometry.exe SHAPE [SHAPE_B] PAIRS             nanoseconds for each query
     geometry.exe SHAPE [SHAPE_B] PAIRS --json      the same and all answers, for test/bench/compare
     geometry.exe SHAPE [SHAPE_B] PAIRS --answers   the answers to the casts, as in an answer file
     geometry.exe SHAPE [SHAPE_B] PAIRS --discrete-answers   apart, touching or inside, a pair a line
     geometry.exe SHAPE [SHAPE_B] PAIRS --check N   the first N answers against all separating axes
     geometry.exe SHAPE [SHAPE_B] PAIRS --lengths   what longer numbers cost

   B has the shape of A unless SHAPE_B is given. A file of kissing pairs (rows of seven numbers) has contact
   tests only. The solids are made before the clock starts. 'one-off' makes the obstacle inside the query and so
   remembers nothing of the pair; 'again' has made it before, and asks the same of each pair in every pass. *)

open Scc_exact
open Scc_geometry
module Data = Scc_test_data.Test_data
module Naive = Scc_naive.Naive

type case = {
  a : Solid.t;
  b : Solid.t;
  naive_a : Naive.solid;  (** where it stands *)
  naive_b : Vec.t -> Naive.solid;  (** displaced *)
  near : Vec.t;
  cast : (Vec.t * Vec.t) option;  (** offset and velocity of B *)
}

(* {1 Reading} *)

let pairs shape_a shape_b path =
  let plain_a = Data.shape shape_a and plain_b = Data.shape shape_b in
  let a = Data.solid ~id:0 plain_a Mat.identity in
  let template_b = (Data.solid ~id:1 plain_b Mat.identity).polyhedron in
  let solid_b i turn = Solid.make ~id:(2 + (2 * i)) template_b turn in
  let moved turn plain at = Naive.move turn at plain in
  if Data.is_kissing path then
    let case i (turn, near) =
      { a = Solid.make ~id:(3 + (2 * i)) a.polyhedron turn;
        b = solid_b i turn;
        naive_a = moved turn plain_a Vec.zero;
        naive_b = moved turn plain_b;
        near;
        cast = None }
    in
    Array.mapi case (Data.kissing path)
  else
    let case i (c : Data.case) =
      { a;
        b = solid_b i c.turn;
        naive_a = plain_a;
        naive_b = moved c.turn plain_b;
        near = c.near;
        cast = Some (c.far, c.velocity) }
    in
    Array.mapi case (Data.pairs path)

(* {1 Answers} *)

let relation_word = function
  | Obstacle.Apart -> "apart"
  | Touching -> "touching"
  | Interpenetrating -> "inside"

let cast_answer c (from, velocity) = Data.answer (Obstacle.make c.a c.b) from velocity
let discrete_answer c = relation_word (Obstacle.relation (Obstacle.make c.a c.b) c.near)

(* The casts of a set; none of a set of kissing pairs. *)
let casts cases =
  Array.of_list (List.filter_map (fun c -> Option.map (fun q -> (c, q)) c.cast) (Array.to_list cases))

(* {1 Against all separating axes} *)

let naive_cast c (from, velocity) =
  let b = c.naive_b from in
  let collision =
    match Naive.first_time_of_contact c.naive_a b velocity with
    | Never -> "never"
    | Inside -> "inside"
    | At t -> "collide " ^ Rat.to_string t
  in
  collision ^ " | " ^ Data.touch_word (Naive.meeting c.naive_a b velocity)

let naive_discrete c =
  match Naive.relation c.naive_a (c.naive_b c.near) with
  | Apart -> "apart"
  | Touching -> "touching"
  | Interpenetrating -> "inside"

let check cases count =
  let wrong = ref 0 in
  let compare i what found expected =
    if not (String.equal found expected) then (
      incr wrong;
      Printf.printf "pair %d, %s: %s, and all separating axes say %s\n" i what found expected)
  in
  let count = Int.min count (Array.length cases) in
  for i = 0 to count - 1 do
    let c = cases.(i) in
    compare i "contact" (discrete_answer c) (naive_discrete c);
    Option.iter (fun q -> compare i "cast" (cast_answer c q) (naive_cast c q)) c.cast
  done;
  Printf.printf "%d pairs checked, %d wrong answers\n" count !wrong;
  if !wrong > 0 then exit 1

(* {1 Times} *)

(* Keeps the results alive. *)
let sink = ref 0

let count_cast = function Obstacle.At _ -> incr sink | Never | Inside -> ()
let count_relation r = if r = Obstacle.Touching then incr sink

(* Processor time for one call of [f], in nanoseconds: the mean over as many passes through 0 to n - 1 as take
   a tenth of a second, after one pass to warm up. *)
let nanoseconds n f =
  let pass () =
    for i = 0 to n - 1 do
      f i
    done
  in
  pass ();
  let start = Sys.time () in
  let rec passes k =
    pass ();
    let elapsed = Sys.time () -. start in
    if elapsed < 0.1 then passes (k + 1) else elapsed *. 1e9 /. float_of_int (k * n)
  in
  passes 1

(* How many of the pairs needed all facets of their obstacle, since the quick way found no proof. *)
let made_facets kept =
  Array.fold_left (fun n (o : Obstacle.t) -> if Scc_base.Later.is_known o.all then n + 1 else n) 0 kept

type row = { query : string; name : string; ns : float; answers : string array }

let measure cases =
  let casts = casts cases in
  let n = Array.length cases and m = Array.length casts in
  let solids =
    nanoseconds n (fun i ->
        let c = cases.(i) in
        sink := !sink + Array.length (Solid.make ~id:1 c.b.polyhedron c.b.linear).vertices)
  in
  let cast o i = let _, (r, w) = casts.(i) in count_cast (Obstacle.first_time_of_contact o r w) in
  let relation o i = count_relation (Obstacle.relation o cases.(i).near) in
  let cast_once =
    nanoseconds m (fun i -> let c, _ = casts.(i) in cast (Obstacle.make c.a c.b) i)
  in
  let relation_once = nanoseconds n (fun i -> relation (Obstacle.make cases.(i).a cases.(i).b) i) in
  (* Only now, so that what is kept does not burden the garbage collector before. *)
  let kept = Array.map (fun c -> Obstacle.make c.a c.b) cases in
  let cast_again = nanoseconds m (fun i -> cast kept.(i) i) in
  let relation_again = nanoseconds n (fun i -> relation kept.(i) i) in
  let cast_rows =
    if m = 0 then []
    else
      [ { query = "cast"; name = "scc one-off"; ns = cast_once;
          answers = Array.map (fun (c, q) -> cast_answer c q) casts };
        { query = "cast"; name = "scc again"; ns = cast_again; answers = [||] } ]
  in
  cast_rows
  @ [ { query = "discrete"; name = "scc one-off"; ns = relation_once;
        answers = Array.map discrete_answer cases };
      { query = "discrete"; name = "scc again"; ns = relation_again; answers = [||] };
      { query = "facets"; name = "scc one-off"; ns = float_of_int (made_facets kept); answers = [||] };
      { query = "make"; name = "scc solid"; ns = solids; answers = [||] } ]

let print_row r =
  if String.equal r.query "facets" then Printf.printf "pairs that needed all facets: %.0f\n" r.ns
  else Printf.printf "%-10s %-12s %10.0f ns\n" r.query r.name r.ns

(* {1 Long numbers}

   Offsets and velocities get fractions below one of the given number of bits, from a congruential generator. *)

let fraction bits seed =
  let modulus = Z.shift_left Z.one 64 in
  let step k = Z.rem (Z.add (Z.mul k (Z.of_string "6364136223846793005")) (Z.of_int 1442695040888963)) modulus in
  let rec digits k acc n =
    if n <= 0 then acc
    else digits (step k) (Z.add (Z.shift_left acc 32) (Z.shift_right k 32)) (n - 32)
  in
  let number seed = Z.rem (digits (step (Z.of_int seed)) Z.zero (bits + 32)) (Z.shift_left Z.one bits) in
  let den = Z.logor (number (2 * seed)) (Z.logor Z.one (Z.shift_left Z.one (bits - 1))) in
  Rat.make (Z.rem (number ((2 * seed) + 1)) den) den

let lengthen bits seed (v : Vec.t) =
  if bits = 0 then v
  else
    let f = fraction bits seed in
    Vec.add v (Vec.make f f f)

let lengths cases =
  let casts = casts cases in
  let n = Array.length cases and m = Array.length casts in
  let first = ref None in
  Printf.printf "%6s %12s %12s %12s\n" "bits" "cast ns" "of which" "contact ns";
  List.iter
    (fun bits ->
       let moving =
         Array.mapi (fun i (_, (r, w)) -> (lengthen bits i r, lengthen bits (i + m) w)) casts
       in
       let near = Array.mapi (fun i c -> lengthen bits i c.near) cases in
       let cast =
         nanoseconds m (fun i ->
             let c, _ = casts.(i) and r, w = moving.(i) in
             count_cast (Obstacle.first_time_of_contact (Obstacle.make c.a c.b) r w))
       in
       (* The time of contact is a fraction in lowest terms: one division of this kind is part of each answer. *)
       let quotient =
         nanoseconds m (fun i ->
             let r, w = moving.(i) in
             if Rat.sign (Rat.div r.x (Rat.add w.x (Rat.of_int 7_919))) = 0 then incr sink)
       in
       let contact =
         nanoseconds n (fun i ->
             count_relation (Obstacle.relation (Obstacle.make cases.(i).a cases.(i).b) near.(i)))
       in
       if Option.is_none !first then first := Some (cast, contact);
       let base = Option.get !first in
       Printf.printf "%6d %12.0f %12.0f %12.0f   x %.2f   x %.2f\n%!" bits cast quotient contact
         (cast /. fst base) (contact /. snd base))
    [ 0; 16; 32; 64; 128; 256; 512; 1024; 4096 ]

let json rows =
  let quoted s = "\"" ^ s ^ "\"" in
  let row r =
    let answers = String.concat "," (Array.to_list (Array.map quoted r.answers)) in
    Printf.sprintf "{\"query\":%s,\"name\":%s,\"ns\":%.1f,\"answers\":[%s]}" (quoted r.query) (quoted r.name)
      r.ns answers
  in
  Printf.printf "{\"program\":\"scc\",\"rows\":[%s]}\n" (String.concat "," (List.map row rows))

(* {1 Command line} *)

type mode = Times | Json | Lengths | Answers | Discrete_answers | Check of int

let usage () =
  prerr_endline
    "usage: geometry.exe SHAPE [SHAPE_B] PAIRS [--json | --answers | --discrete-answers | --check N | --lengths]";
  exit 2

let run mode cases =
  match mode with
  | Times -> List.iter print_row (measure cases)
  | Json -> json (measure cases)
  | Lengths -> lengths cases
  | Answers -> Array.iter (fun (c, q) -> print_endline (cast_answer c q)) (casts cases)
  | Discrete_answers -> Array.iter (fun c -> print_endline (discrete_answer c)) cases
  | Check count -> check cases count

let rec parse mode files = function
  | [] -> (mode, List.rev files)
  | "--json" :: rest -> parse Json files rest
  | "--lengths" :: rest -> parse Lengths files rest
  | "--answers" :: rest -> parse Answers files rest
  | "--discrete-answers" :: rest -> parse Discrete_answers files rest
  | "--check" :: count :: rest -> (
      match int_of_string_opt count with
      | Some k -> parse (Check k) files rest
      | None -> usage ())
  | file :: rest when not (String.length file > 1 && file.[0] = '-') -> parse mode (file :: files) rest
  | _ -> usage ()

let main () =
  match parse Times [] (List.tl (Array.to_list Sys.argv)) with
  | mode, [ shape; file ] -> run mode (pairs shape shape file)
  | mode, [ shape; shape_b; file ] -> run mode (pairs shape shape_b file)
  | _ -> usage ()

let () =
  let refuse message =
    prerr_endline ("geometry.exe: " ^ message);
    exit 2
  in
  try main () with
  | Sys_error message -> refuse message
  | Failure _ | Invalid_argument _ | End_of_file ->
    refuse "a file is not in the formats of test/data/geometry/README.md"
