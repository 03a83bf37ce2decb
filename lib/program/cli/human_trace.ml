open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_runs

(* Passings of the same time, one after the other: they are told once it is known that no other follows. *)
type passing = {
  first : int;
  last : int;
  duration : Rat.t;
  rules : string;
  time : Rat.t;  (** after the last of them, as is the state *)
  state : State.t option;
}

type t = {
  model : Model.t;
  full : bool;
  write : string -> unit;
  mutable passing : passing option;
  mutable known : State.t option;  (** the state that was told last *)
}

let line t fmt = Printf.ksprintf (fun s -> t.write (s ^ "\n")) fmt
let number t = Run_text.number ~full:t.full

let tell_state t s =
  let same p (k : State.t) = Array.exists (State.equal_process p) k.processes in
  let aside p = match t.known with Some k when same p k -> Some "as before" | Some _ | None -> None in
  List.iter (line t "        %s") (Run_text.state ~full:t.full ~aside t.model s);
  t.known <- Some s

let tell_passing t p =
  let label = Transition.Time p.duration in
  if p.first = p.last then line t "%5d.  %s   {%s}" p.first (Run_text.label ~full:t.full t.model label) p.rules
  else
    line t "%5s.  %s   {%s}"
      (Printf.sprintf "%d-%d" p.first p.last)
      (Run_text.passes ~full:t.full (p.last - p.first + 1) p.duration)
      p.rules;
  line t "time %s" (number t p.time);
  Option.iter (tell_state t) p.state

let flush t =
  Option.iter (tell_passing t) t.passing;
  t.passing <- None

let pass t p =
  match t.passing with
  | Some q when Rat.equal q.duration p.duration && String.equal q.rules p.rules ->
    t.passing <- Some { p with first = q.first }
  | Some _ | None ->
    flush t;
    t.passing <- Some p

let ending : Replay.ending -> string = function
  | Open -> "more can happen"
  | Quiescent -> "nothing will ever happen again"
  | Stuck _ -> "nothing can happen, not even the passing of time"
  | Zeno -> "stopped: too many transitions without time passing"
  | Broken_off -> "interrupted"

let teller model ~full states write =
  let t = { model; full; write; passing = None; known = None } in
  fun (e : Replay.event) ->
    match e with
    | Start s ->
      line t "time 0";
      tell_state t s
    | Step { number = n; index; among; time; taken; state = after; _ } -> (
        let rules = String.concat ", " (List.map Rule.id taken.rules) in
        let state = match (states : Trace.states) with All -> Some (after ()) | Ends -> None in
        match taken.label with
        | Time duration when among = 1 && not full -> pass t { first = n; last = n; duration; rules; time; state }
        | label ->
          flush t;
          let choice = if among > 1 then Printf.sprintf " (choice %d of %d)" index among else "" in
          line t "%5d.  %s%s   {%s}" n (Run_text.label ~full model label) choice rules;
          line t "time %s" (number t time);
          Option.iter (tell_state t) state)
    | Instant { offset; time; state } ->
      flush t;
      line t "        time passes by %s" (number t offset);
      line t "time %s" (number t time);
      tell_state t state
    | End { steps; time; ending = how; last; rounded } ->
      flush t;
      (match (states, last) with
       | Ends, Some s when steps > 0 -> tell_state t (s ())
       | (All | Ends), _ -> ());
      line t "%d transitions, time %s: %s" steps (number t time) (ending how);
      Option.iter (fun totals -> List.iter (line t "%s") (Run_text.rounded totals)) rounded
