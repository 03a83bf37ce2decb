open Scc_base
open Scc_exact
open Scc_syntax

type t = {
  mass : (Rat.t * Span.t) option;
  velocity : (Vec.t * Span.t) option;
  spin : (Vec.t * Span.t) option;
  absorb : Span.t option;
  at : Placement.t;
  complete : bool;
}

let none = { mass = None; velocity = None; spin = None; at = Placement.identity; absorb = None; complete = true }

let kind (a : Ast.attribute) =
  match a.it with
  | Mass _ -> "mass"
  | Velocity _ -> "velocity"
  | Spin _ -> "spin"
  | At _ -> "at"
  | Absorb -> "absorb"

(* The first of each kind; the others are reported. *)
let once report attributes =
  let keep kept (a : Ast.attribute) =
    match List.find_opt (fun b -> String.equal (kind a) (kind b)) kept with
    | None -> a :: kept
    | Some (first : Ast.attribute) ->
      Report.error report Code.repeated_attribute a.at "`%s` is given twice" (kind a)
        ~notes:[ (first.at, "the first is here") ];
      kept
  in
  List.rev (List.fold_left keep [] attributes)

let motion = "the times at which bodies meet would not be linear in it"

let add report env t (a : Ast.attribute) =
  let incomplete = { t with complete = false } in
  match a.it with
  | Mass e -> (
      match Constant.positive ~why:"impulses would not be linear in it" report env "mass" e with
      | Some m -> { t with mass = Some (m, a.at) }
      | None -> { incomplete with mass = Some (Rat.one, a.at) })
  | Velocity v -> (
      match Constant.vector ~why:motion report env v with
      | Some v -> { t with velocity = Some (v, a.at) }
      | None -> { incomplete with velocity = Some (Vec.zero, a.at) })
  | Spin v -> (
      match Constant.vector ~why:motion report env v with
      | Some v -> { t with spin = Some (v, a.at) }
      | None -> { incomplete with spin = Some (Vec.zero, a.at) })
  | Absorb -> { t with absorb = Some a.at }
  | At ts -> (
      match Constant.transform report env ts with
      | Some at -> { t with at }
      | None -> incomplete)

let read report env attributes = List.fold_left (add report env) none (once report attributes)

let vector = function
  | Some (v, _) -> v
  | None -> Vec.zero

let velocity t = vector t.velocity
let spin t = vector t.spin
