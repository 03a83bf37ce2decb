open Scc_exact

let version = "2"

let rec releases (b : Behaviour.t) =
  match b with
  | Weak _ -> true
  | Nil | Call _ -> false
  | Open (_, _, b) | Strong (_, b) | Delay (_, b) -> releases b
  | Sum (b, c) -> releases b || releases c

let may_split (m : Model.t) (s : State.t) =
  Array.exists (fun (d : Behaviour.definition) -> releases d.body) m.definitions
  || Array.exists
    (fun (p : State.process) ->
       Array.exists (fun (l : State.leaf) -> releases l.behaviour.term) p.leaves)
    s.processes

let dynamics : Model.dynamics -> string = function
  | Constant_spin -> "constant_spin"
  | Free_body -> "free_body"

let rounded what = function
  | Some k -> [ ("round " ^ what, Printf.sprintf "2^-%d" k) ]
  | None -> []

let rigid (r : Model.rigid) =
  [ ("dynamics", dynamics r.dynamics); ("resolution", Rat.to_string r.resolution) ]
  @ rounded "orientation" r.round_orientation

let steps m = if Model.of_each m then " local" else if Model.keeps_beat m then " steady" else ""

let listed (m : Model.t) s =
  (if may_split m s then [ ("split step", Rat.to_string m.split_step) ] else [])
  @ (if not (m.steered || Option.is_some m.rigid) then []
     else [ ("timestep", Rat.to_string m.timestep ^ steps m) ])
  @ (match m.collisions with Together -> [ ("collisions", "together") ] | In_turn -> [])
  @ (match m.binding with On_contact -> [ ("binding", "contact") ] | On_collision -> [])
  @ Option.fold ~none:[] ~some:rigid m.rigid
  @ rounded "velocity" m.round_velocity

let line = function
  | [] -> "semantics " ^ version
  | listed ->
    let one (name, value) = name ^ " " ^ value in
    Printf.sprintf "semantics %s: %s" version (String.concat ", " (List.map one listed))
