open Scc_base
open Scc_exact
open Scc_mesh
open Scc_syntax

(* Each found when it is needed, and once. *)
type near = { side : Curved.side; ball : Curved.t Lazy.t; disc : Curved.t Lazy.t }
type t = near option

let none = None
let near side d = Some { side; ball = lazy (Curved.sphere side d); disc = lazy (Curved.disc side d) }
let most = Rat.make Z.one (Z.of_int 2)
let rough = near Curved.Inscribed most

let read plain (word : Ast.name) e =
  let side = match word.it with "circumscribed" -> Curved.Circumscribed | _ -> Curved.Inscribed in
  match Plain.number plain e with
  | Error at ->
    Fault.refuse Code.unknown_points at "how near curved solids are taken is a plain number, and this is none"
  | Ok d ->
    if Rat.compare d Curved.least < 0 || Rat.compare d most > 0 then
      Fault.refuse Code.bad_curve e.at "curved solids are taken as near as 1/2 to %s of their radius, and not %s"
        (Rat.to_string Curved.least) (Rat.to_string d);
    near side d

type curved =
  | Sphere of Curved.t * Ast.expr
  | Cylinder of Curved.t * Ast.expr * Ast.expr
  | Cone of Curved.t * Ast.expr * Ast.expr

let notes = function
  | None -> []
  | Some { side; ball; disc } ->
    let word = match side with Curved.Inscribed -> "inscribed in" | Circumscribed -> "circumscribed about" in
    let note what which (c : Curved.t) =
      Printf.sprintf "%s is %s it by %d corners to a turn, at the Hausdorff distance of at most %s of its radius"
        what word which (Rat.to_string c.distance)
    in
    let made what c = if Lazy.is_val c then List.map (fun w -> note w (Lazy.force c).Curved.corners
                                                         (Lazy.force c)) what else [] in
    made [ "what stands for a sphere" ] ball @ made [ "what stands for a cylinder or cone" ] disc

let taken t (r : Ast.reference) which =
  match t with
  | Some near -> Lazy.force (which near)
  | None ->
    Fault.refuse Code.bad_curve r.target.at "the model does not say as which polyhedron a %s is taken"
      r.target.it
      ~hint:"declare `curved inscribed 1/20`, or `circumscribed`: as near as a twentieth of the radius"

let curved t (r : Ast.reference) =
  match (r.qualifier, r.indices, r.target.it, r.arguments) with
  | None, [], "sphere", [ radius ] -> Some (Sphere (taken t r (fun n -> n.ball), radius))
  | None, [], "cylinder", [ radius; height ] -> Some (Cylinder (taken t r (fun n -> n.disc), radius, height))
  | None, [], "cone", [ radius; height ] -> Some (Cone (taken t r (fun n -> n.disc), radius, height))
  | None, [], (("sphere" | "cylinder" | "cone") as name), _ ->
    Fault.refuse Code.bad_arity r.target.at "a %s takes %s" name
      (match name with "sphere" -> "its radius" | _ -> "the radius and the height")
  | _ -> None

let ball_name corners = Printf.sprintf "sphere'%d" corners
let radius (c : Curved.t) r = Rat.mul c.factor r

let times span factor (e : Ast.expr) : Ast.expr =
  if Rat.equal factor Rat.one then e
  else
    match Plain.number Plain.none e with
    | Ok r -> Tree.number span (Rat.mul factor r)
    | Error _ -> Tree.at span (Ast.Binary (Mul, Tree.number span factor, e))

let reference span name arguments : Ast.reference =
  { qualifier = None; target = Tree.at span name; indices = []; arguments }

let count span n = Tree.number span (Rat.of_int n)

let solid span = function
  | Sphere (c, r) ->
    let r = times span c.factor r in
    let ball = Tree.at span (Ast.Template (reference span (ball_name c.corners) [])) in
    Ast.Scaled (ball, Tree.at span (Ast.Vector (r, r, r)))
  | Cylinder (c, r, h) -> Template (reference span "prism" [ count span c.corners; times span c.factor r; h ])
  | Cone (c, r, h) -> Template (reference span "pyramid" [ count span c.corners; times span c.factor r; h ])
