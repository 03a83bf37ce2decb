(* Times the cast of turning bodies over one step, for test/bench/check-turning:

     turning_cast.exe --make SHAPE N SEED > PAIRS   makes pairs: a third hit, a third are near misses, a third far
     turning_cast.exe SHAPE PAIRS                   nanoseconds for each query, and all answers (JSON)
     turning_cast.exe --straight SHAPE PAIRS        without spin, beside the translational cast (JSON)
     turning_cast.exe --gaps SHAPE PAIRS I...       how near the I-th pairs come when they turn as parry turns them

   SHAPE is a file of test/data/geometry, taken at 1/1024 of its size. A line of PAIRS is the kind of pair (hit,
   near, far), and for each of the two bodies its centre, velocity and spin, and the quaternion w, x, y, z that it
   is turned by at first: 26 numbers, all of which floats hold exactly. The motions are made before the
   clock starts. *)

open Scc_exact
open Scc_geometry
open Scc_rigid
module Cases = Scc_turning.Turning_cases
module Turning = Scc_naive.Turning
module Guide = Scc_naive.Turning_guide
module Rng = Scc_long.Rng

let resolution = Scc_turning.Turning_check.resolution

(* {1 Files} *)

let kinds = [| ("hit", Cases.Hit); ("near", Cases.Near_miss); ("far", Cases.Far) |]

let vector (v : Vec.t) = List.map (fun r -> Printf.sprintf "%.17g" (Rat.to_float r)) [ v.x; v.y; v.z ]

let print_body (b : Turning.body) =
  let w, x, y, z = b.turned in
  vector b.centre @ vector b.velocity @ vector b.spin @ List.map Rat.to_string [ w; x; y; z ]

let make shape count seed =
  for i = 0 to count - 1 do
    let name, kind = kinds.(i mod 3) in
    let c = Cases.make kind shape shape (Rng.make [ 31; seed; i ]) in
    print_endline (String.concat " " ((name :: print_body c.a) @ print_body c.b))
  done

let read (shape : Cases.shape) path =
  let body words : Turning.body =
    let r = Array.of_list (List.map (fun w -> Q.of_float (float_of_string w)) words) in
    let vector i = Vec.make r.(i) r.(i + 1) r.(i + 2) in
    { solid = shape.plain;
      turned = (r.(9), r.(10), r.(11), r.(12));
      arm = Vec.zero;
      centre = vector 0;
      velocity = vector 3;
      spin = vector 6;
      since = Rat.zero }
  in
  let pair line =
    match List.filter (fun w -> w <> "") (String.split_on_char ' ' line) with
    | kind :: words when List.length words = 26 ->
      let half keep = body (List.filteri (fun i _ -> keep i) words) in
      let a = half (fun i -> i < 13) in
      let b = half (fun i -> i >= 13) in
      (kind, { Cases.shape_a = shape; shape_b = shape; a; b; span = Rat.one; grazes = false })
    | _ -> failwith "not a file of pairs"
  in
  Array.map pair (Scc_test_data.Test_data.lines path)

(* {1 Times} *)

(* Keeps the results alive. *)
let sink = ref 0

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

let quoted s = "\"" ^ s ^ "\""

let row ?(answers = [||]) query name ns =
  let answers = String.concat "," (Array.to_list (Array.map quoted answers)) in
  Printf.sprintf "{\"query\":%s,\"name\":%s,\"ns\":%.1f,\"answers\":[%s]}" (quoted query) (quoted name) ns answers

let print rows = Printf.printf "{\"program\":\"scc\",\"rows\":[%s]}\n" (String.concat "," rows)

let count : Cast.outcome -> unit = function At _ -> incr sink | Never | Inside -> ()

let cast (a, b) = Cast.first_time_of_contact a b ~span:Rat.one ~grid:(Cast.grid a b ~resolution)

let turning pairs =
  let motions = Array.map (fun (kind, c) -> (kind, Cases.motions c)) pairs in
  let of_kind name =
    let some = List.filter (fun (kind, _) -> name = "all" || String.equal kind name) (Array.to_list motions) in
    let some = Array.of_list (List.map snd some) in
    let answers =
      if name <> "all" then [||]
      else
        Array.map
          (fun m ->
             match cast m with
             | Cast.Never -> "never"
             | Inside -> "inside"
             | At t -> Printf.sprintf "hit %.17g" (Rat.to_float t))
          some
    in
    row ~answers name "scc" (nanoseconds (Array.length some) (fun i -> count (cast some.(i))))
  in
  let of_kinds = List.map of_kind [ "hit"; "near"; "far"; "all" ] in
  let grid i =
    let a, b = snd motions.(i) in
    sink := !sink + Cast.grid a b ~resolution
  in
  print (of_kinds @ [ row "all" "scc grid" (nanoseconds (Array.length motions) grid) ])

(* Solids that were turned beforehand, as those of models without spin are. The translational cast is asked with
   the differences of the motions, and for any time: what comes after the step is no contact in the step. *)
let straight pairs =
  let pair i (_, (c : Cases.case)) =
    let still id (b : Turning.body) (solid : Solid.t) : Motion.t =
      let linear = Option.get (Mat.of_quaternion b.turned) in
      { solid = Solid.make ~id solid.polyhedron linear;
        turned = Quaternion.identity;
        arm = Vec.zero;
        centre = b.centre;
        velocity = b.velocity;
        spin = Vec.zero;
        since = Rat.zero }
    in
    let a = still (2 * i) c.a (fst c.shape_a.solids) and b = still ((2 * i) + 1) c.b (snd c.shape_b.solids) in
    (a, b, Cast.grid a b ~resolution)
  in
  let pairs = Array.mapi pair pairs in
  let n = Array.length pairs in
  let along obstacle i =
    let (a : Motion.t), (b : Motion.t), _ = pairs.(i) in
    match Obstacle.first_time_of_contact obstacle (Vec.sub b.centre a.centre) (Vec.sub b.velocity a.velocity) with
    | At t when Rat.compare t Rat.one < 0 -> incr sink
    | At _ | Never | Inside -> ()
  in
  let rigid ?obstacle i =
    let a, b, grid = pairs.(i) in
    count (Cast.first_time_of_contact ?obstacle a b ~span:Rat.one ~grid)
  in
  let make i =
    let (a : Motion.t), (b : Motion.t), _ = pairs.(i) in
    Obstacle.make a.solid b.solid
  in
  let same =
    Array.mapi
      (fun i ((a : Motion.t), (b : Motion.t), grid) ->
         let scale = Rat.make (Z.shift_left Z.one grid) Z.one in
         let expected : Cast.outcome =
           let offset = Vec.sub b.centre a.centre and velocity = Vec.sub b.velocity a.velocity in
           match Obstacle.first_time_of_contact (make i) offset velocity with
           | At t when Rat.compare t Rat.one < 0 ->
             At (Rat.make (Rat.floor (Rat.mul t scale)) (Z.shift_left Z.one grid))
           | Inside -> Inside
           | At _ | Never -> Never
         in
         match (expected, Cast.first_time_of_contact a b ~span:Rat.one ~grid) with
         | Never, Never | Inside, Inside -> "same"
         | At t, At u when Rat.equal t u -> "same"
         | _ -> "different")
      pairs
  in
  let once = nanoseconds n (fun i -> along (make i) i) in
  let rigid_once = nanoseconds n (fun i -> rigid i) in
  let kept = Array.init n make in
  let again = nanoseconds n (fun i -> along kept.(i) i) in
  let rigid_again = nanoseconds n (fun i -> rigid ~obstacle:kept.(i) i) in
  print
    [ row "one-off" "translational" once; row ~answers:same "one-off" "rigid" rigid_once;
      row "again" "translational" again; row "again" "rigid" rigid_again ]

let gaps pairs numbers =
  let gap i =
    let c = snd pairs.(i) in
    let g = Turning.guide ~law:Uniform c.Cases.a c.b ~span:Rat.one in
    snd (Guide.least ~samples:256 (Guide.gap g))
  in
  List.iter (fun i -> Printf.printf "%.17g\n" (gap i)) numbers

(* {1 Command line} *)

let usage () =
  prerr_endline
    "usage: turning_cast.exe --make SHAPE N SEED | SHAPE PAIRS | --straight SHAPE PAIRS | --gaps SHAPE PAIRS I...";
  exit 2

let main () =
  match List.tl (Array.to_list Sys.argv) with
  | [ "--make"; shape; n; seed ] -> make (Cases.read shape) (int_of_string n) (int_of_string seed)
  | [ "--straight"; shape; file ] -> straight (read (Cases.read shape) file)
  | "--gaps" :: shape :: file :: numbers -> gaps (read (Cases.read shape) file) (List.map int_of_string numbers)
  | [ shape; file ] -> turning (read (Cases.read shape) file)
  | _ -> usage ()

let () =
  let refuse message =
    prerr_endline ("turning_cast.exe: " ^ message);
    exit 2
  in
  try main () with
  | Sys_error message | Failure message -> refuse message
