open Scc_geometry
open Scc_calculus

type t = { setting : Kinematics.setting; kinematics : (module Kinematics.S); memo : Memo.t }

let kinematics (m : Model.t) : (module Kinematics.S) =
  match m.rigid with None -> (module Straight) | Some _ -> (module Turning)

let afresh = Geometry.exact ~obstacle:(fun a b -> Obstacle.make a b)

let make ?(geometry = afresh) ?(neighbours = Kinematics.everyone) ?(laws = Kinematics.ask_again)
    ?(memo = Memo.none) model =
  { setting = { model; geometry; neighbours; laws }; kinematics = kinematics model; memo }

let without_memo t = { t with memo = Memo.none }
let model t = t.setting.model

let with_model t model =
  { setting = { t.setting with model }; kinematics = kinematics model; memo = t.memo.renewed () }
