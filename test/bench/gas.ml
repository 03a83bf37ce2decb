(* A gas of cubes in a box of six fixed walls, run for a model time:

     gas.exe N TIME [--seed S] [--shapes cubes|turned|mixed] [--write FILE] [--events FILE]

   [--write FILE] writes the initial condition, so that another simulator can run the same gas. Numbers are
   rationals, [p] or [p/q]; fields are separated by one space:

     N L TIME                                      the box is [0, L] along every axis
     x y z vx vy vz half mass qw qx qy qz          one line for each body

   Each body is a cube: [-half, half] along every axis, turned by the quaternion q = (w, x, y, z), which is not a
   unit, with its centre at (x, y, z). Nothing ever spins; bodies bounce elastically, without friction.

   [--events FILE] writes a line for each collision, in order of time: its time (decimal, rounded), and the
   two bodies, from 0 in the order of the initial condition. A wall comes second: -1 for x = 0, -2 for x = L,
   -3 and -4 for y, -5 and -6 for z. *)

open Scc_base
open Scc_exact

type options = {
  count : int;
  time : Rat.t;
  seed : int64;
  shapes : Gas_start.shapes;
  write : string option;
  events : string option;
}

let usage () =
  prerr_endline
    "usage: gas.exe N TIME [--seed S] [--shapes cubes|turned|mixed] [--write FILE] [--events FILE]";
  exit 2

let shapes = function
  | "cubes" -> Gas_start.Cubes
  | "turned" -> Turned
  | "mixed" -> Mixed
  | _ -> usage ()

let rec read o = function
  | [] -> o
  | "--seed" :: s :: rest -> (
      match Int64.of_string_opt s with Some seed -> read { o with seed } rest | None -> usage ())
  | "--shapes" :: s :: rest -> read { o with shapes = shapes s } rest
  | "--write" :: file :: rest -> read { o with write = Some file } rest
  | "--events" :: file :: rest -> read { o with events = Some file } rest
  | _ -> usage ()

let options = function
  | n :: t :: rest -> (
      match (int_of_string_opt n, Rat.of_literal t) with
      | Some count, Ok time when count > 0 && Rat.sign time >= 0 ->
        read { count; time; seed = 1L; shapes = Cubes; write = None; events = None } rest
      | _ -> usage ())
  | _ -> usage ()

let with_file path f =
  let channel = open_out_bin path in
  Fun.protect ~finally:(fun () -> close_out channel) (fun () -> f channel)

let () =
  let o = options (List.tl (Array.to_list Sys.argv)) in
  let start = Gas_start.make o.shapes ~count:o.count ~seed:o.seed in
  Option.iter (fun path -> with_file path (fun c -> Gas_start.write c start ~time:o.time)) o.write;
  if Option.is_some o.events then Bug.fail __POS__ "not yet"
