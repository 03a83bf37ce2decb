open Scc_exact

let version = "3"

(* Whether some prefix that is written anywhere is so. *)
let exists_prefix is (m : Model.t) (s : State.t) =
  let rec within b = is b || List.exists within (Behaviour.parts b) in
  let of_process (p : State.process) =
    Array.exists (fun (l : State.leaf) -> within l.behaviour.term) p.leaves
  in
  Array.exists (fun (d : Behaviour.definition) -> within d.body) m.definitions
  || Array.exists of_process s.processes

let may_split = exists_prefix (function Weak _ -> true | _ -> false)

let may_push =
  exists_prefix (function
      | Weak (_, { push = j; _ }, _) | Strong (_, j, _) -> Rat.sign j > 0
      | Nil | Open _ | Delay _ | Wait _ | Sum _ | Call _ -> false)

let has_lots =
  exists_prefix (function
      | Weak (_, { odds = Some _; _ }, _) -> true
      | Weak _ | Nil | Open _ | Strong _ | Delay _ | Wait _ | Sum _ | Call _ -> false)

let dynamics : Model.dynamics -> string = function
  | Constant_spin -> "constant_spin"
  | Free_body -> "free_body"

let rounded what = function
  | Some k -> [ ("round " ^ what, Printf.sprintf "2^-%d" k) ]
  | None -> []

let rigid (r : Model.rigid) =
  [ ("dynamics", dynamics r.dynamics); ("resolution", Rat.to_string r.resolution) ]
  @ rounded "orientation" r.round_orientation

let at_any_time = ("split step", "any")

let splits : Model.splits -> string * string = function
  | Every step -> ("split step", Rat.to_string step)
  | Any_time -> at_any_time

let steps m = if Model.of_each m then " local" else if Model.keeps_beat m then " steady" else ""

let listed (m : Model.t) s =
  (if may_split m s then [ splits m.splits ] else [])
  @ (if not (m.steered || Option.is_some m.rigid) then []
     else [ ("timestep", Rat.to_string m.timestep ^ steps m) ])
  @ (match m.collisions with
      | Together -> [ ("collisions", "together") ]
      | Drawn -> [ ("collisions", "drawn") ]
      | In_turn -> [])
  @ (match m.binding with On_contact -> [ ("binding", "contact") ] | On_collision -> [])
  @ (match m.bonds with Cyclic -> [ ("bonds", "cyclic") ] | Acyclic -> [])
  @ (match m.blocked with Stop -> [ ("blocked", "stop") ] | Wait -> [ ("blocked", "wait") ] | Bounce -> [])
  @ Option.fold ~none:[] ~some:rigid m.rigid
  @ rounded "velocity" m.round_velocity

let line = function
  | [] -> "semantics " ^ version
  | listed ->
    let one (name, value) = name ^ " " ^ value in
    Printf.sprintf "semantics %s: %s" version (String.concat ", " (List.map one listed))
