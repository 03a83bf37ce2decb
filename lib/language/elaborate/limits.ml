open Scc_base
open Scc_syntax

let depth = 10_000
let operators = 1_000
let items = 1_000_000
let terms = 4_000_000
let number_bits = 1_000_000

type node =
  | Expr of Ast.expr
  | Solid of Ast.solid
  | Behaviour of Ast.behaviour
  | Item of Ast.item

let expr e = Expr e
let vector v = [ Expr v ]
let path (p : Ast.path) = List.concat_map (fun (s : Ast.segment) -> List.map expr s.indices) p.it

let feature (f : Ast.feature) =
  match f.it with
  | Named p -> path p
  | Tuple (prefix, vertices) -> List.concat_map path (Option.to_list prefix @ vertices)

let channel (c : Ast.channel) = List.concat_map (fun (m : Ast.member) -> feature m.feature) c.features

let bound = function
  | None -> []
  | Some (Ast.Within e | Ast.At_most e) -> [ Expr e ]
  | Some (Ast.Between (a, b)) -> [ Expr a; Expr b ]

let transform (t : Ast.transform) =
  match t.it with
  | Translate v | Scale v -> vector v
  | Rotate (a, b, c, d) -> List.map expr [ a; b; c; d ]
  | Matrix rows -> List.concat_map (fun (a, b, c, d) -> List.map expr [ a; b; c; d ]) rows

let attribute (a : Ast.attribute) =
  match a.it with
  | Mass e -> [ Expr e ]
  | Velocity v | Spin v -> vector v
  | Absorb -> []
  | At ts -> List.concat_map transform ts

let leaf (l : Ast.leaf) =
  (Solid l.solid :: List.concat_map attribute l.attributes)
  @ List.map (fun b -> Behaviour b) (Option.to_list l.behaviour)

let bond (b : Ast.bond) = feature b.first @ feature b.second

let bounds (r : Ast.bounds) = Expr r.low :: Expr r.high :: List.map expr (Option.to_list r.filter)

let ranged = function
  | Ast.Bodies e -> [ Expr e ]
  | Ast.Numbers r -> bounds r

let reference (r : Ast.reference) = List.map expr (r.indices @ r.arguments)
let head (h : Ast.head) = List.map expr h.places
let definitions ds = List.map (fun (_, e) -> Expr e) ds

let outcome = function
  | Ast.Does e -> [ Expr e ]
  | Goes_until (f, b, g) -> Expr f :: Expr g :: bound b
  | Has_at (e, t) -> [ Expr e; Expr t ]

let expr_children (e : Ast.expr) =
  match e.it with
  | Number _ | True | False | Co _ -> []
  | Path p -> path p
  | Apply_in (p, _, es) -> path p @ List.map expr es
  | Component (a, _) -> [ Expr a ]
  | Apply (_, es) | Event (_, es) -> List.map expr es
  | Neg a | Not a -> [ Expr a ]
  | Quantified (_, _, over, a) -> Expr a :: ranged over
  | Vector (a, b, c) -> [ Expr a; Expr b; Expr c ]
  | Binary (_, a, b) -> [ Expr a; Expr b ]
  | If (a, b, c) -> [ Expr a; Expr b; Expr c ]
  | Temporal (_, b, a) -> Expr a :: bound b
  | Measured (m, test, o) -> Expr m :: (Option.to_list (Option.map (fun (_, e) -> Expr e) test) @ outcome o)
  | Until (_, a, b, c) | Leads_to (a, b, c) -> Expr a :: Expr c :: bound b

let push j = Option.to_list (Option.map (fun e -> Expr e) j)

let behaviour_children (b : Ast.behaviour) =
  match b.it with
  | Nil -> []
  | Name k -> reference k
  | Open (c, b) -> Behaviour b :: channel c
  | Weak (c, j, b) ->
    let odds = Option.map (fun (o : Ast.odds) -> Expr o.value) j.odds in
    (Behaviour b :: channel c) @ push j.push @ Option.to_list odds
  | Strong (cs, j, b) -> (Behaviour b :: List.concat_map channel cs) @ push j
  | Delay (e, b) -> [ Expr e; Behaviour b ]
  | Sum (a, b) -> [ Behaviour a; Behaviour b ]

let solid_children (s : Ast.solid) =
  match s.it with
  | Template t -> reference t
  | Mesh (_, m) -> List.map (fun e -> Expr e) (Option.to_list m.grid @ Option.to_list m.snap)
  | Scaled (s, v) -> Solid s :: vector v
  | Faces (vertices, _) | Hull vertices -> List.concat_map (fun (_, v) -> vector v) vertices

let range (r : Ast.range) = bounds r.bounds

let law (l : Ast.law) =
  match l.it with
  | Inertial -> []
  | Expression (v, spin) -> vector v @ List.concat_map vector (Option.to_list spin)
  | Choose kicks ->
    let kick (k : Ast.kick) =
      List.concat_map range k.over @ vector k.velocity
      @ List.concat_map vector (Option.to_list k.spin)
      @ List.map expr (Option.to_list k.weight)
    in
    List.concat_map kick kicks

let part (p : Ast.part) = Solid p.part_solid :: List.concat_map attribute p.part_attributes
let glue (g : Ast.glue) = feature g.glue_first @ feature g.glue_second

let item_children (i : Ast.item) =
  match i.it with
  | Model _ | Import _ | Dynamics _ | Collisions _ | Binding _ | Bonds _ | Blocked _ -> []
  | Param (_, e) | Timestep (e, _) | Split_step e | Resolution e | Round (_, e) | Let (_, e)
  | Check (_, e) -> [ Expr e ]
  | Param_in (_, low, high) -> [ Expr low.value; Expr high.value ]
  | Shape (h, s, ds) -> (Solid s :: head h) @ definitions ds
  | Compound (h, parts, glues, ds) ->
    List.append (List.concat_map part parts) (List.concat_map glue glues) @ head h @ definitions ds
  | Decomposed (h, s, attributes, ds) ->
    (Solid s :: List.concat_map attribute attributes) @ head h @ definitions ds
  | Behaviour (h, on, b, ds) ->
    (Behaviour b :: head h) @ List.concat_map reference (Option.to_list on) @ definitions ds
  | Process (s, l, rest) | Fixed (s, l, rest) ->
    List.map expr s.indices @ leaf l @ List.concat_map (fun (b, l) -> bond b @ leaf l) rest
  | Bond b -> bond b
  | For (ranges, items) ->
    List.append
      (List.concat_map range ranges)
      (List.map (fun i -> Item i) items)
  | Network ps -> List.concat_map path ps
  | Motion (p, l) -> List.concat_map path (Option.to_list p) @ law l

let children = function
  | Expr e -> expr_children e
  | Solid s -> solid_children s
  | Behaviour b -> behaviour_children b
  | Item i -> item_children i

let exists_in test e =
  let rec look = function
    | [] -> false
    | Expr e :: rest -> test e || look (List.rev_append (children (Expr e)) rest)
    | (Solid _ | Behaviour _ | Item _) :: rest -> look rest
  in
  look [ Expr e ]

let rec within = function
  | [] -> true
  | (level, _) :: _ when level > depth -> false
  | (level, node) :: rest ->
    within (List.fold_left (fun rest c -> (level + 1, c) :: rest) rest (children node))

let check_depth report (model : Ast.model) =
  List.iter
    (fun (i : Ast.item) ->
       if not (within [ (0, Item i) ]) then
         Report.error report Code.too_deep i.at "this nests more than %d levels deep" depth)
    model
