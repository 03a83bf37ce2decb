open Scc_base
open Scc_exact
open Scc_syntax

let at at it : 'a Ast.loc = { it; at }
let surface = "\001region"
let segment name : Ast.segment = { name; indices = [] }
let path span names = at span (List.map (fun n -> segment (at span n)) names)

let feature (x : Ast.expr) =
  at x.at (Ast.Named (at x.at [ { Ast.name = at x.at surface; indices = [ x ] } ]))

let region (f : Ast.feature) =
  match f.it with
  | Named { it = [ { name; indices = [ x ] } ]; _ } when String.equal name.it surface -> Some x
  | Named _ | Tuple _ -> None

type declared = Region of Ast.name * Ast.name * Ast.expr | Curved of Ast.name * Ast.expr

let keyword = function
  | `Region (name, shape) -> "\002region " ^ name ^ " on " ^ shape
  | `Curved word -> "\002curved " ^ word

let declared (i : Ast.item) =
  match i.it with
  | Let (n, x) when String.length n.it > 0 && n.it.[0] = '\002' -> (
      match String.split_on_char ' ' n.it with
      | [ _; name; _; shape ] -> Some (Region (at n.at name, at n.at shape, x))
      | [ _; word ] -> Some (Curved (at n.at word, x))
      | _ -> Bug.fail __POS__ "a declaration of neither kind")
  | _ -> None

let item = function
  | Region (name, shape, x) -> Ast.Let (at name.at (keyword (`Region (name.it, shape.it))), x)
  | Curved (word, x) -> Ast.Let (at word.at (keyword (`Curved word.it)), x)

let integer span z : Ast.expr =
  let size = at span (Ast.Number (Q.of_bigint (Z.abs z))) in
  if Z.sign z < 0 then at span (Ast.Neg size) else size

let number span q =
  let top = integer span (Q.num q) in
  if Rat.is_integer q then top else at span (Ast.Binary (Div, top, integer span (Q.den q)))

let vector span (v : Vec.t) = at span (Ast.Vector (number span v.x, number span v.y, number span v.z))
