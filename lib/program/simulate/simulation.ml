open Scc_base
open Scc_system
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_runs
open Scc_export

type plan = {
  semantics : Semantics.t;
  declared : State.t;
  observables : Table.observable list;
  times : Rat.t array;
  steps : int option;
}

let most_times = 1_000_000

let too_many ~every ~until = Z.gt (Rat.floor (Rat.div until every)) (Z.of_int most_times)

let times ~every ~until =
  let n = Z.to_int (Rat.floor (Rat.div until every)) in
  let multiples = Array.init (n + 1) (fun k -> Rat.mul (Rat.of_int k) every) in
  if Rat.equal multiples.(n) until then multiples else Array.append multiples [| until |]

(* The increment of SplitMix64. *)
let golden = 0x9E3779B97F4A7C15L

let seed_of seed k =
  fst (Splitmix64.next (Splitmix64.of_seed (Int64.add seed (Int64.mul (Int64.of_int k) golden))))

type run = {
  number : int;
  values : Rat.t option array array;
  reached : int;
  ended : string option;
  interrupted : bool;
}

let observed plan state =
  Array.of_list (List.map (fun o -> Table.exact plan.semantics o state) plan.observables)

(* The instants of a stretch of time, from its beginning on up to its end, which belongs to what comes next. *)
let look plan values next ~start ~lasts state =
  let over = Rat.add start lasts in
  let rec go () =
    if !next < Array.length plan.times && Rat.compare plan.times.(!next) over < 0 then begin
      let offset = Rat.sub plan.times.(!next) start in
      let there = state () in
      let there = if Rat.sign offset = 0 then there else Time.pass plan.semantics offset there in
      values.(!next) <- observed plan there;
      incr next;
      go ()
    end
  in
  go ()

(* What turns for ever does so without an event. *)
let look_onwards plan values next time state =
  let lasts = Rat.sub plan.times.(Array.length plan.times - 1) time in
  let piece ~start ~lasts s = look plan values next ~start ~lasts (fun () -> s) in
  Ray.follow plan.semantics ~start:time ~lasts:(Rat.add lasts Rat.one) state piece

(* Of a run that is over at a time, what it is then. *)
let look_at_end plan values next time state =
  if !next < Array.length plan.times && Rat.equal plan.times.(!next) time then begin
    values.(!next) <- observed plan (state ());
    incr next
  end

let why_over plan ~counted ~steps ~time (ending : Replay.ending) =
  let at = "at time " ^ Rat.to_string time in
  match ending with
  | Open when plan.steps = Some counted -> Printf.sprintf "ended by `--steps %d`, %s" counted at
  | Open | Quiescent -> "over " ^ at
  | Broken_off -> Printf.sprintf "interrupted after %d transitions, %s" steps at
  | Zeno -> Printf.sprintf "goes on for ever within one instant, %s" at
  | Stuck g -> Printf.sprintf "over %s: %s" at (Transition.diagnostic (Semantics.model plan.semantics)
                                                  g.fault).message

let run plan ~seed ~interrupted number =
  let none = Array.make (List.length plan.observables) None in
  let values = Array.make (Array.length plan.times) none and next = ref 0 in
  let until = plan.times.(Array.length plan.times - 1) in
  let ended = ref None and cut = ref false and taken = ref 0 and counted = ref 0 and now = ref Rat.zero in
  let is_done () = !next >= Array.length plan.times in
  let finish ~steps ~time ending =
    if not (is_done ()) then ended := Some (why_over plan ~counted:!counted ~steps ~time ending)
  in
  let note : Replay.event -> unit = function
    | Start _ -> ()
    | Step s ->
      taken := s.number;
      if not s.draws_on then incr counted;
      now := s.time
    | Instant i -> look_at_end plan values next i.time (fun () -> i.state)
    | End { steps; time; ending; last; _ } ->
      (match (ending, last) with
       | Quiescent, Some state -> look_onwards plan values next time (state ())
       | (Open | Stuck _), Some state -> look_at_end plan values next time state
       | _, _ -> ());
      finish ~steps ~time ending
  in
  let limits = { Replay.steps = plan.steps; time = Some until; instant = Replay.default_instant } in
  let passing ~start ~lasts state = look plan values next ~start ~lasts state in
  let policy = Replay.Random (seed_of seed number) in
  (match Replay.run ~passing ~joint:true plan.semantics plan.declared policy limits ~interrupted note with
   | Ok _ -> ()
   | Error (Fault g) ->
     let message = (Transition.diagnostic (Semantics.model plan.semantics) g.fault).message in
     ended := Some (Printf.sprintf "over at time %s: %s" (Rat.to_string g.time) message)
   | Error (Interrupted _) | (exception Interruption.Interrupted _) ->
     cut := not (is_done ());
     finish ~steps:!taken ~time:!now Broken_off
   | Error (Refused _) -> Bug.fail __POS__ "a run that nobody leads");
  { number; values; reached = !next; ended = !ended; interrupted = !cut }
