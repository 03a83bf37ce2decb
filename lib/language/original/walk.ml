open Scc_syntax

type t = {
  channel : Ast.channel -> Ast.channel;
  feature : Ast.feature -> Ast.feature;
  solid : Ast.solid -> Ast.solid;
}

let same = { channel = Fun.id; feature = Fun.id; solid = Fun.id }

(* As deep as the text is: at most Tokens.max_depth. *)
let rec behaviour w (b : Ast.behaviour) : Ast.behaviour =
  let it : Ast.behaviour_kind =
    match b.it with
    | Nil | Name _ -> b.it
    | Open (c, next) -> Open (w.channel c, behaviour w next)
    | Weak (c, l, next) -> Weak (w.channel c, l, behaviour w next)
    | Strong (cs, j, next) -> Strong (List.map w.channel cs, j, behaviour w next)
    | Delay (t, next) -> Delay (t, behaviour w next)
    | Sum (x, y) -> Sum (behaviour w x, behaviour w y)
  in
  { b with it }

let leaf w (l : Ast.leaf) =
  { l with solid = w.solid l.solid; behaviour = Option.map (behaviour w) l.behaviour }

let bond w (b : Ast.bond) = { b with first = w.feature b.first; second = w.feature b.second }
let glue w (g : Ast.glue) =
  { g with glue_first = w.feature g.glue_first; glue_second = w.feature g.glue_second }

let part w (p : Ast.part) = { p with part_solid = w.solid p.part_solid }
let chain w rest = List.map (fun (b, l) -> (bond w b, leaf w l)) rest

let rec item w (i : Ast.item) : Ast.item =
  let it : Ast.item_kind =
    match i.it with
    | Shape (h, s, ds) -> Shape (h, w.solid s, ds)
    | Compound (h, parts, glues, ds) ->
      Compound (h, List.map (part w) parts, List.map (glue w) glues, ds)
    | Behaviour (h, on, b, ds) -> Behaviour (h, on, behaviour w b, ds)
    | Process (s, first, rest) -> Process (s, leaf w first, chain w rest)
    | Fixed (s, first, rest) -> Fixed (s, leaf w first, chain w rest)
    | Bond b -> Bond (bond w b)
    | For (ranges, body) -> For (ranges, List.map (item w) body)
    | Decomposed _ | Model _ | Import _ | Param _ | Param_in _ | Timestep _ | Split_step _ | Dynamics _
    | Collisions _ | Binding _ | Bonds _ | Blocked _ | Resolution _ | Round _ | Network _ | Motion _ | Let _ | Check _ -> i.it
  in
  { i with it }
