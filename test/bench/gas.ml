(* A gas of cubes in a box of six fixed walls, run for a model time:

     gas.exe N TIME [--seed S] [--shapes cubes|turned|mixed] [--check] [--write FILE] [--events FILE]

   Prints how many events there were (collisions), what one of them cost in processor time, how many exact casts
   and how many neighbours were looked at for it, and how the numbers grew. With [--check], every event is checked
   to conserve momentum (unless one of the two is a wall) and kinetic energy, exactly; the times then say nothing.

   [--write FILE] writes the initial condition, so that another simulator can run the same gas. Numbers are
   rationals, [p] or [p/q]; fields are separated by one space:

     N L TIME                                      the box is [0, L] along every axis
     x y z vx vy vz half mass qw qx qy qz          one line for each body

   Each body is a cube: [-half, half] along every axis, turned by the quaternion q = (w, x, y, z), which is not a
   unit, with its centre at (x, y, z). Nothing ever spins; bodies bounce elastically, without friction.

   [--events FILE] writes a line for each collision, in order of time: its time (decimal, rounded), and the
   two bodies, from 0 in the order of the initial condition. A wall comes second: -1 for x = 0, -2 for x = L,
   -3 and -4 for y, -5 and -6 for z. *)

open Scc_exact
open Scc_calculus
open Scc_engine

let standard = Scc_engine.Standard.of_model

type options = {
  count : int;
  time : Rat.t;
  seed : int64;
  shapes : Gas_start.shapes;
  check : bool;
  write : string option;
  events : string option;
}

let usage () =
  prerr_endline
    "usage: gas.exe N TIME [--seed S] [--shapes cubes|turned|mixed] [--check] [--write FILE] [--events FILE]";
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
  | "--check" :: rest -> read { o with check = true } rest
  | "--write" :: file :: rest -> read { o with write = Some file } rest
  | "--events" :: file :: rest -> read { o with events = Some file } rest
  | _ -> usage ()

let options = function
  | n :: t :: rest -> (
      match (int_of_string_opt n, Rat.of_literal t) with
      | Some count, Ok time when count > 0 && Rat.sign time >= 0 ->
        read { count; time; seed = 1L; shapes = Cubes; check = false; write = None; events = None } rest
      | _ -> usage ())
  | _ -> usage ()

let with_file path f =
  let channel = open_out_bin path in
  Fun.protect ~finally:(fun () -> close_out channel) (fun () -> f channel)

(* {1 What an event conserves} *)

type moving = { mass : Rat.t option;  (** none: a wall *) velocity : Vec.t }

let moving (m : Model.t) run first =
  let leaf = m.leaves.(first) in
  { mass = (if leaf.fixed then None else Some leaf.mass); velocity = Event_run.velocity run first }

let momentum a = match a.mass with Some m -> Vec.scale m a.velocity | None -> Vec.zero
let energy a = match a.mass with Some m -> Rat.mul m (Vec.norm2 a.velocity) | None -> Rat.zero

let conserved (p, q) (p', q') =
  let sum add f (a, b) = add (f a) (f b) in
  let walls = Option.is_none p.mass || Option.is_none q.mass in
  Rat.equal (sum Rat.add energy (p, q)) (sum Rat.add energy (p', q'))
  && (walls || Vec.equal (sum Vec.add momentum (p, q)) (sum Vec.add momentum (p', q')))

(* {1 The run} *)

let fail message =
  prerr_endline message;
  exit 1

let write_event channel o time (p, q) =
  let name i = if i < o.count then i else o.count - i - 1 in
  Printf.fprintf channel "%.17g %d %d\n" (Rat.to_float time) (name p) (name q)

(* How many events there are. *)
let simulate o m run log =
  let rec from events =
    match if Event_run.count run = 0 then None else Some (Event_run.label run 0) with
    | None -> events
    | Some (Time d) ->
      if Rat.compare (Rat.add (Event_run.elapsed run) d) o.time > 0 then events
      else begin
        ignore (Event_run.take run 0);
        from events
      end
    | Some (Bounce { firsts = [ p; q ]; _ }) ->
      let both () = (moving m run p, moving m run q) in
      let before = if o.check then Some (both ()) else None in
      ignore (Event_run.take run 0);
      Option.iter
        (fun before -> if not (conserved before (both ())) then fail "momentum or energy is lost")
        before;
      Option.iter (fun channel -> write_event channel o (Event_run.elapsed run) (p, q)) log;
      from (events + 1)
    | Some _ -> fail "a gas only bounces"
  in
  from 0

(* {1 Numbers} *)

(* Mean and greatest number of bits of the coordinates of bodies and their velocities. *)
let bits o (s : State.t) =
  let count = ref 0 and total = ref 0 and greatest = ref 0 in
  let number q =
    let n = Rat.bits q in
    incr count;
    total := !total + n;
    greatest := Int.max !greatest n
  in
  let vector (v : Vec.t) = List.iter number [ v.x; v.y; v.z ] in
  Array.iteri
    (fun i (p : State.process) ->
       if i < o.count then begin
         vector p.leaves.(0).position;
         vector p.velocity
       end)
    s.processes;
  (float_of_int !total /. float_of_int !count, !greatest)

let report o (before, seconds) events run (work : Flights.work) =
  let each n = float_of_int n /. float_of_int (Int.max 1 events) in
  let mean, greatest = bits o (Event_run.state run) in
  Printf.printf "%d bodies, %s units of time, %d events%s\n" o.count (Rat.to_string o.time) events
    (if o.check then ": each conserves momentum and energy" else "");
  Printf.printf "%.3f s, %.1f us/event; per event %.1f sweeps, %.1f neighbours, %.1f exact casts\n" seconds
    (1e6 *. seconds /. float_of_int (Int.max 1 events))
    (each work.sweeps) (each work.neighbours) (each work.casts);
  Printf.printf
    "bits of a coordinate: mean %.1f at the start, %.1f at the end (greatest %d), %.2f per event of a body\n"
    before mean greatest
    ((mean -. before) *. float_of_int o.count /. (2. *. float_of_int (Int.max 1 events)))

let run o start log =
  let m, s = Gas_start.network start in
  let before, _ = bits o s in
  let began = Sys.time () in
  let run = Event_run.start (standard m) s in
  let built = Sys.time () in
  let first_work = Event_run.work run in
  let events = simulate o m run log in
  let ended = Sys.time () in
  let work = Event_run.work run in
  Printf.printf "%.3f s to start\n" (built -. began);
  report o (before, ended -. built) events run
    {
      sweeps = work.sweeps - first_work.sweeps;
      neighbours = work.neighbours - first_work.neighbours;
      casts = work.casts - first_work.casts;
    }

let () =
  let o = options (List.tl (Array.to_list Sys.argv)) in
  Scc_base.Memory.spare_runs ();
  let start = Gas_start.make o.shapes ~count:o.count ~seed:o.seed in
  Option.iter (fun path -> with_file path (fun c -> Gas_start.write c start ~time:o.time)) o.write;
  match o.events with
  | None -> run o start None
  | Some path -> with_file path (fun channel -> run o start (Some channel))
