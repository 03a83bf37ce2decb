open Scc_calculus
module Gen = QCheck2.Gen

type t = {
  together : bool;
  steps : Model.steps;
  by_contact : bool;
  pushes : bool;
  rings : bool;
  absorbs : bool;
  rounding : int option;
}

let off =
  {
    together = false; steps = Model.Shared; by_contact = false; pushes = false; rings = false; absorbs = false;
    rounding = None;
  }

let together = { off with together = true }
let local = { off with steps = Own }
let by_contact = { off with by_contact = true }
let absorbing = { off with absorbs = true }
let rounding = { off with rounding = Some 2 }
let rings = { off with rings = true }
let pushes s = s.pushes
let closes_rings s = s.rings
let absorbs s = s.absorbs
let without_pushes s = { s with pushes = false }

let generate ?(rigid = false) () =
  let open Gen in
  let* together = frequencyl [ (2, true); (1, false) ] in
  let+ steps = oneofl [ Model.Shared; Own; Steady ] and* pushes = bool and* rings = bool and* absorbs = bool
  and* by_contact = if rigid then pure false else bool in
  { together; steps; by_contact; pushes; rings; absorbs; rounding = None }

let apply s (m : Model.t) =
  {
    m with
    collisions = (if s.together then Together else In_turn);
    binding = (if s.by_contact then On_contact else On_collision);
    bonds = (if s.rings then Cyclic else Acyclic);
    steps = s.steps;
    round_velocity = (match s.rounding with None -> m.round_velocity | Some _ as k -> k);
  }

let print s =
  let word on w = if on then w else "" in
  word s.together " together"
  ^ (match s.steps with Shared -> "" | Own -> " local" | Steady -> " steady")
  ^ word s.by_contact " contact"
  ^ word s.pushes " pushes"
  ^ word s.rings " rings"
  ^ word s.absorbs " absorbing"
  ^ word (Option.is_some s.rounding) " rounding"
