open Scc_base
open Scc_syntax

type ('n, 'c) value = ('n, 'c) Algebra.value = Num of 'n | Cond of 'c | Vec of 'n * 'n * 'n
type budget = Algebra.budget = { mutable left : int; mutable spent_on : Span.t }

module type ALGEBRA = Algebra.S

let budget () = { left = Limits.terms; spent_on = Span.none }
let both = Operations.both
let functions = Operations.functions

let without_brackets functions name =
  if List.mem name functions then Some (Printf.sprintf "its arguments stand in brackets after it: `%s(...)`" name)
  else None
let described = Operations.described
let unknown_function = Operations.unknown_function

let axes = [ "x"; "y"; "z" ]

module Make (A : ALGEBRA) = struct
  include Operations.Make (A)

  let spend ctx =
    let budget = A.budget ctx in
    budget.left <- budget.left - 1;
    if budget.left = 0 then
      error ctx Code.too_deep budget.spent_on
        "the laws and formulas of the model have more than %d terms, written out"
        Limits.terms;
    budget.left > 0

  let rec at_depth ctx depth env (e : Ast.expr) =
    if depth > Limits.depth then begin
      error ctx Code.too_deep e.at "this nests more than %d levels deep, with its `let`s" Limits.depth;
      None
    end
    else if not (spend ctx) then None
    else
      match e.it with
      | Number q -> Some (Num (A.const q))
      | True -> Some (Cond (A.bool true))
      | False -> Some (Cond (A.bool false))
      | Path path -> name ctx depth env path
      | Vector (x, y, z) ->
        let component = num_at ctx (depth + 1) env in
        let x = component x and y = component y and z = component z in
        let*? x, y = both x y in
        let*? z = z in
        Some (Vec (x, y, z))
      | Neg a -> (
          match at_depth ctx (depth + 1) env a with
          | Some (Vec (x, y, z)) -> Some (Vec (negated x, negated y, negated z))
          | other -> num (Option.map negated (as_num ctx a.at other)))
      | Not a -> Option.map (fun c -> Cond (negate c)) (cond_at ctx (depth + 1) env a)
      | Binary (op, a, b) -> binary ctx depth env e.at op a b
      | If (c, a, b) -> conditional ctx depth env c a b
      | Apply (f, es) when List.mem f.it functions -> apply ctx depth env e.at f.it es
      | Component (v, axis) -> component ctx axis (as_vec ctx v.at (at_depth ctx (depth + 1) env v))
      | Apply _ | Apply_in _ | Co _ | Quantified _ | Temporal _ | Until _ | Measured _ | Leads_to _ | Event _ ->
        A.other ctx (at_depth ctx (depth + 1)) env e

  and num_at ctx depth env (e : Ast.expr) = as_num ctx e.at (at_depth ctx depth env e)
  and cond_at ctx depth env (e : Ast.expr) = as_cond ctx e.at (at_depth ctx depth env e)

  and name ctx depth env (path : Ast.path) =
    match (Env.value env path.it, path.it) with
    | Some (Unknown, [ { name = axis; indices = [] } ]), _ ->
      if not (List.mem axis.it axes) then no_component ctx axis;
      None
    | Some (Unknown, _), _ -> None
    | Some (v, []), first :: _ -> value_of ctx depth path.at first.Ast.name v
    | Some (((Vector _ | Macro _) as v), [ { name = axis; indices = [] } ]), first :: _ ->
      component ctx axis (as_vec ctx path.at (value_of ctx depth path.at first.Ast.name v))
    | None, [ { name = m; indices = [] }; { name = n; indices = [] } ] when Env.is_module env m.it ->
      error ctx Code.unknown_name n.at "`%s` has no value `%s`" m.it n.it;
      None
    | _ -> A.variable ctx env path

  and value_of ctx depth at (name : Ast.name) (v : Env.value) =
    match v with
    | Number q -> Some (Num (A.const q))
    | Truth b -> Some (Cond (A.bool b))
    | Vector v -> Some (Vec (A.const v.x, A.const v.y, A.const v.z))
    | Affine form -> num (A.affine ctx at form)
    | Open n -> num (A.open_number ctx at n)
    | Macro (body, scope) -> at_depth ctx (depth + 1) scope body
    | Word (w, _) ->
      error ctx Code.wrong_kind at "`%s` stands for the name `%s`, and a value is expected here" name.it w;
      None
    | Unknown -> None
    | Leaf _ ->
      error ctx Code.wrong_kind at "`%s` stands for a process, and a value is expected here" name.it
        ~hint:(Printf.sprintf "say what of it is meant, as in `x(%s)`" name.it);
      None

  and component ctx (axis : Ast.name) v =
    let*? x, y, z = v in
    match axis.it with
    | "x" -> Some (Num x)
    | "y" -> Some (Num y)
    | "z" -> Some (Num z)
    | _ ->
      no_component ctx axis;
      None

  and no_component ctx (axis : Ast.name) =
    error ctx Code.unknown_name axis.at "a vector has the components x, y and z"

  (* What is written out several times is read as often, so that it is counted as often: functions within
     functions would make terms beyond every limit. *)
  and again ctx depth env times e value =
    if not (is_constant value) then
      for _ = 2 to times do
        if (A.budget ctx).left > 0 then ignore (at_depth ctx (depth + 1) env e)
      done

  and apply ctx depth env at name es =
    let values = List.map (at_depth ctx (depth + 1) env) es in
    if List.exists Option.is_none values then check_arity ctx at name (List.length values);
    let*? values = all values in
    if not (List.for_all is_constant values) then
      List.iter2 (fun e v -> again ctx depth env (Operations.copies name) e v) es values;
    if (A.budget ctx).left > 0 then call ctx at name values else None

  and binary ctx depth env at op a b =
    match op with
    | Mod -> apply ctx depth env at "mod" [ a; b ]
    | Add | Sub | Mul | Div -> (
        let operand e = at_depth ctx (depth + 1) env e in
        let*? x, y = both (operand a) (operand b) in
        match (x, y) with
        | Cond _, _ ->
          ignore (as_num ctx a.at (Some x));
          None
        | _, Cond _ ->
          ignore (as_num ctx b.at (Some y));
          None
        | Num _, Vec _ ->
          again ctx depth env 3 a x;
          operate ctx at op x y
        | Vec _, Num _ ->
          again ctx depth env 3 b y;
          operate ctx at op x y
        | (Num _ | Vec _), _ -> operate ctx at op x y)
    | And | Or | Implies ->
      let*? x, y = both (cond_at ctx (depth + 1) env a) (cond_at ctx (depth + 1) env b) in
      Some (Cond (connective op x y))
    | Lt | Le | Gt | Ge | Eq | Ne -> (
        match (A.comparison ctx env op a b, comparison_of op) with
        | Some result, _ -> result
        | None, Some c -> (
            let*? x, y = both (at_depth ctx (depth + 1) env a) (at_depth ctx (depth + 1) env b) in
            match (op, x, y) with
            | (Eq | Ne), Vec (a, b, c), Vec (x, y, z) ->
              let equal = conj (compare Eq a x) (conj (compare Eq b y) (compare Eq c z)) in
              Some (Cond (match op with Ne -> negate equal | _ -> equal))
            | _ ->
              let*? x, y = both (as_num ctx a.at (Some x)) (as_num ctx b.at (Some y)) in
              Some (Cond (compare c x y)))
        | None, None -> Bug.fail __POS__ "not a comparison")

  and conditional ctx depth env c a b =
    let below = at_depth ctx (depth + 1) env in
    let condition = cond_at ctx (depth + 1) env c in
    let branches = both (below a) (below b) in
    let*? condition = condition in
    match branches with
    | None -> None
    | Some (Num x, Num y) -> (
        match A.truth condition with
        | Some t -> Some (Num (if t then x else y))
        | None -> Option.map (fun n -> Num n) (A.choose ctx c.at condition x y))
    | Some (Cond x, Cond y) -> (
        match A.truth condition with
        | Some t -> Some (Cond (if t then x else y))
        | None ->
          (* What is made has the condition twice: read again, it is counted twice. Otherwise conditions
             within conditions would make terms beyond every limit. *)
          let*? _ = cond_at ctx (depth + 1) env c in
          Some (Cond (A.choose_cond condition x y)))
    | Some (Vec (p, q, r), Vec (x, y, z)) ->
      (match A.truth condition with
       | Some _ -> ()
       | None ->
         for _ = 2 to 3 do
           ignore (cond_at ctx (depth + 1) env c)
         done);
      each (choose ctx c.at condition) (p, q, r) (x, y, z)
    | Some (((Num _ | Cond _ | Vec _) as x), y) ->
      error ctx Code.type_mismatch b.at "the branches of `if` are %s and %s" (described x) (described y);
      None

  let eval ctx env (e : Ast.expr) =
    (A.budget ctx).spent_on <- e.at;
    at_depth ctx 0 env e

  let num ctx env (e : Ast.expr) = as_num ctx e.at (eval ctx env e)
  let cond ctx env (e : Ast.expr) = as_cond ctx e.at (eval ctx env e)
  let vec ctx env (e : Ast.expr) = as_vec ctx e.at (eval ctx env e)
end
