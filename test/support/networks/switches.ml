open Scc_calculus
module Gen = QCheck2.Gen

type t = {
  together : bool;
  steps : Model.steps;
  by_contact : bool;
  pushes : bool;
  rings : bool;
  absorbs : bool;
  draws : bool;
  lots : bool;
  rounding : int option;
}

let off =
  {
    together = false; steps = Model.Shared; by_contact = false; pushes = false; rings = false; absorbs = false;
    draws = false; lots = false; rounding = None;
  }

let together = { off with together = true }
let local = { off with steps = Own }
let by_contact = { off with by_contact = true }
let absorbing = { off with absorbs = true }
let rounding = { off with rounding = Some 2 }
let rings = { off with rings = true }
let drawing = { off with draws = true }
let lots = { off with lots = true }
let has_lots s = s.lots
let draws s = s.draws
let pushes s = s.pushes
let closes_rings s = s.rings
let absorbs s = s.absorbs
let without_pushes s = { s with pushes = false }

let generate ?(rigid = false) ?(draws = true) () =
  let open Gen in
  let* together = frequencyl [ (2, true); (1, false) ] in
  let+ steps = oneofl [ Model.Shared; Own; Steady ] and* pushes = bool and* rings = bool and* absorbs = bool
  and* draws = if draws then bool else pure false
  and* lots = if draws then bool else pure false
  and* by_contact = if rigid then pure false else bool in
  { together; steps; by_contact; pushes; rings; absorbs; draws; lots; rounding = None }

let minus_two_dt v : Law.expr = Sub (Var v, Mul (Const (Scc_exact.Rat.of_int 2), Var Dt))
let fall = Law.velocity_alone (Var Vx, minus_two_dt Vy, Var Vz)

(* Seen alike from what moves on in a straight line. With a velocity that several kicks come to, one that is never
   drawn, and weights that depend on the body. *)
let kicks : Law.kick list =
  let const n = Law.Const (Scc_exact.Rat.of_int n) in
  [
    { motion = fall; weight = const 2 };
    { motion = Law.velocity_alone (Add (Var Vx, const 1), Var Vy, Sub (Var Vz, const 1)); weight = Var Mass };
    { motion = Law.velocity_alone (Div (Var Vx, const 0), Var Vy, Var Vz); weight = const 0 };
    { motion = Law.velocity_alone (Var Vx, Var Vy, Var Vz); weight = Div (const 1, const 2) };
    { motion = fall; weight = If (Compare (Gt, Var Dt, const 0), const 1, const 0) };
  ]

let law s : Law.t = if s.draws then Choose kicks else Gives fall

let apply s (m : Model.t) =
  {
    m with
    collisions = (if s.together then Together else In_turn);
    binding = (if s.by_contact then On_contact else On_collision);
    bonds = (if s.rings then Cyclic else Acyclic);
    steps = s.steps;
    lots = s.lots;
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
  ^ word s.draws " drawing"
  ^ word s.lots " lots"
  ^ word (Option.is_some s.rounding) " rounding"
