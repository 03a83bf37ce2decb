open Scc_base
open Scc_exact
open Scc_syntax
open Scc_calculus

(* The name at the head of an expression that is no constant. *)
let described (e : Ast.expr) =
  match e.it with
  | Apply (f, _) -> Printf.sprintf "`%s(…)`" f.it
  | Apply_in _ -> Printf.sprintf "`%s`" (Printer.expr e)
  | Co n -> Printf.sprintf "`~%s`" n.it
  | Quantified _ -> "a quantifier"
  | Temporal _ | Until _ | Leads_to _ | Measured _ -> "a temporal operator"
  | Event _ -> "`event`"
  | Number _ | True | False | Path _ | Component _ | Vector _ | Neg _ | Not _ | Binary _ | If _ -> "this"

let of_state =
  [
    "behaviour"; "bonds"; "bound"; "distance2"; "gone"; "offers"; "same"; "size"; "speed2"; "spin2"; "touching";
    "vx"; "vy"; "vz"; "wx"; "wy"; "wz"; "x"; "y"; "z";
  ]

(* Affine in parameters with ranges, or a function of the one that is asked about. *)
type num = Form of Form.t | Open of Open_number.t
type cond = Known of bool | Depends of num

(* Both as functions. The range is that of whichever has one. *)
let open_both f g a b =
  let function_of = function
    | Open n -> Some (n.Open_number.value, n.form)
    | Form form -> Option.map (fun q -> (q, Rational_function.constant q)) (Form.constant form)
  in
  match ((a, b), function_of a, function_of b) with
  | (Open { parameter; _ }, _ | Form _, Open { parameter; _ }), Some (x, p), Some (y, q) ->
    Open { parameter; value = f x y; form = g p q }
  | _ -> Bug.fail __POS__ "two parameters of different kinds in one number"

module Algebra = struct
  type context = { report : Report.t; budget : Typed.budget; why : string option }
  type nonrec num = num
  type nonrec cond = cond

  let report c = c.report
  let budget c = c.budget
  let const q = Form (Form.const q)
  let constant = function Form form -> Form.constant form | Open _ -> None

  let neg = function
    | Form form -> Form (Form.neg form)
    | Open n -> Open { n with value = Rat.neg n.value; form = Rational_function.neg n.form }

  let lift linear f g a b =
    match (a, b) with Form a, Form b -> Form (linear a b) | (Open _ | Form _), _ -> open_both f g a b

  let add = lift Form.add Rat.add Rational_function.add
  let sub = lift Form.sub Rat.sub Rational_function.sub

  (* One of them is a constant, as [admits] sees to. *)
  let linear_mul a b =
    match (Form.constant a, Form.constant b) with
    | Some k, _ -> Form.scale k b
    | None, Some k -> Form.scale k a
    | None, None -> Bug.fail __POS__ "a product that is not linear"

  let linear_div a b =
    match Form.constant b with
    | Some k -> Form.scale (Rat.div Rat.one k) a
    | None -> Bug.fail __POS__ "a quotient that is not linear"

  let mul = lift linear_mul Rat.mul Rational_function.mul
  let div = lift linear_div Rat.div Rational_function.div

  let not_linear c at why n =
    (match n with
     | Form form -> Not_linear.report c.report ~needed:c.budget.spent_on at ~why form
     | Open n -> Not_linear.refuse c.report ~needed:c.budget.spent_on at ~why n);
    None

  let bits = function Form form -> Form.bits form | Open n -> Rational_function.bits n.form

  (* Zero for no value of the parameter. *)
  let divides c at (n : Open_number.t) =
    match Open_number.vanishing n.parameter n.form with
    | None when Rational_function.(equal n.form zero) ->
      Report.error c.report Code.division_by_zero at "division by zero";
      false
    | None -> true
    | Some x ->
      Report.error c.report Code.division_by_zero at "division by zero for %s" (Open_number.at n.parameter x);
      false

  let admits c at (op : Ast.binary) a b =
    let refuse why n =
      ignore (not_linear c at why n);
      false
    in
    match (op, a, b) with
    | Mul, Form x, Form y when Option.is_none (Form.constant x) && Option.is_none (Form.constant y) ->
      refuse "a product of two that are not known is not linear" (Form (Form.add x y))
    | Div, _, Form y when Option.is_none (Form.constant y) ->
      refuse "a quotient by what is not known is not linear" b
    | _, Open n, Form form | _, Form form, Open n when Option.is_none (Form.constant form) ->
      refuse "another parameter with a range stands beside it" (Open n)
    | Div, _, Open n when not (divides c at n) -> false
    | _ when bits a + bits b > Limits.number_bits ->
      Report.error c.report Code.number_too_large at "these numbers are too large (more than %d bits)"
        Limits.number_bits;
      false
    | _ -> true

  let affine c at form = match c.why with None -> Some (Form form) | Some why -> not_linear c at why (Form form)
  let open_number _ _ n = Some (Open n)
  let bool b = Known b
  let truth = function Known b -> Some b | Depends _ -> None

  let compare comparison a b =
    match (a, b) with
    | Form x, Form y -> (
        let d = Form.sub x y in
        match Form.constant d with
        | Some q -> Known (Law.compare_rationals comparison q Rat.zero)
        | None -> Depends (Form d))
    | (Open _ as n), _ | _, n -> Depends n

  let negate = function Known b -> Known (not b) | Depends _ as c -> c
  let either a b = match a with Depends _ -> a | Known _ -> b
  let conj = either
  let disj = either

  let branches = "which of the two is meant depends on it, and the whole would not be linear"

  let choose c at cond a b =
    match cond with
    | Known t -> Some (if t then a else b)
    | Depends n -> not_linear c at branches n

  let choose_cond c a b = either c (either a b)
  let nearest c at what x = not_linear c at (Printf.sprintf "`%s` is not linear" what) x
  let comparison _ _ _ _ _ = None

  let variable c env (path : Ast.path) =
    match path.it with
    | [ { name; indices = [] } ] ->
      Report.error c.report Code.unknown_name path.at "unknown name `%s`; a constant is expected here" name.it
        ?hint:(Typed.without_brackets ("round" :: Typed.functions) name.it)
        ~near:(name.it, fun () -> Env.names env);
      None
    | _ ->
      Report.error c.report Code.type_mismatch path.at "a constant is expected here";
      None

  let round c eval env (e : Ast.expr) (x : Ast.expr) (quantum : Ast.expr) =
    match (eval env x, eval env quantum) with
    | Some (Typed.Num x), Some (Typed.Num q) -> (
        match (constant x, constant q) with
        | Some x, Some q when Rat.sign q > 0 ->
          if Rat.bits x + Rat.bits q > Limits.number_bits then begin
            Report.error c.report Code.number_too_large e.at "this constant is too large";
            None
          end
          else Some (Typed.Num (const (Rat.round_to x ~quantum:q)))
        | Some _, Some q ->
          Report.error c.report Code.bad_value quantum.at "`round` to multiples of %s, which is not positive"
            (Rat.to_string q);
          None
        | None, _ -> not_linear c e.at "`round` is not linear" x
        | _, None -> not_linear c e.at "`round` is not linear" q)
    | Some (Cond _ | Vec _), Some _ | Some _, Some (Cond _ | Vec _) ->
      Report.error c.report Code.type_mismatch e.at "`round` takes two numbers";
      None
    | None, _ | _, None -> None

  let other c eval env (e : Ast.expr) =
    match e.it with
    | Apply ({ it = "round"; _ }, [ x; q ]) -> round c eval env e x q
    | Apply ({ it = "round"; _ }, _) ->
      Report.error c.report Code.bad_arity e.at "`round` takes two arguments, a number and a quantum";
      None
    | Apply (f, _) when not (List.mem f.it of_state) ->
      Typed.unknown_function c.report f ("round" :: Typed.functions);
      None
    | _ ->
      Report.error c.report Code.type_mismatch e.at "a constant is expected here, and %s is none"
        (described e);
      None
end

module Eval = Typed.Make (Algebra)

let context ?why report = { Algebra.report; budget = Typed.budget (); why }

let rec is_constant env (e : Ast.expr) =
  match e.it with
  | Number _ | True | False -> true
  | Path path -> (
      match Env.value env path.it with
      | Some ((Number _ | Truth _ | Vector _), []) | Some (Vector _, [ _ ]) -> true
      | Some ((Number _ | Truth _ | Vector _ | Affine _ | Open _ | Word _ | Macro _ | Leaf _ | Unknown), _)
      | None ->
        false)
  | Apply (f, es) when String.equal f.it "round" || List.mem f.it Typed.functions ->
    List.for_all (is_constant env) es
  | Vector (a, b, c) -> is_constant env a && is_constant env b && is_constant env c
  | Neg a | Not a | Component (a, _) -> is_constant env a
  | Binary (_, a, b) -> is_constant env a && is_constant env b
  | If (a, b, c) -> is_constant env a && is_constant env b && is_constant env c
  | Co _ | Apply _ | Apply_in _ | Quantified _ | Temporal _ | Until _ | Measured _ | Leads_to _ | Event _ -> false

(* Of `let`s within `let`s no more is looked at. *)
let most_looked_at = 10_000

let is_open env e =
  let looked_at = ref 0 in
  let rec unknown env (e : Ast.expr) =
    incr looked_at;
    !looked_at > most_looked_at
    ||
    match e.it with
    | Path path -> (
        match Env.value env path.it with
        | Some (Unknown, _) -> true
        | Some (Macro (e, scope), _) -> Limits.exists_in (unknown scope) e
        | Some ((Number _ | Truth _ | Vector _ | Affine _ | Open _ | Word _ | Leaf _), _) | None -> false)
    | _ -> false
  in
  Limits.exists_in (unknown env) e

let refused report (at : Span.t) ~why = function
  | Form form -> Not_linear.report report at ~why form
  | Open n -> Not_linear.refuse report at ~why n

let value report env (e : Ast.expr) =
  let refuse why n =
    refused report e.at ~why n;
    None
  in
  match Eval.eval (context report) env e with
  | Some (Num (Form form)) -> (
      match Form.constant form with Some q -> Some (Env.Number q) | None -> Some (Env.Affine form))
  | Some (Num (Open n)) -> Some (Env.Open n)
  | Some (Cond (Known b)) -> Some (Env.Truth b)
  | Some (Cond (Depends n)) -> refuse "whether this is so depends on it" n
  | Some (Vec (Form x, Form y, Form z)) -> (
      match Form.fixed (x, y, z) with
      | Some v -> Some (Env.Vector v)
      | None ->
        refuse "an argument that depends on it is a number" (Form (Form.add x (Form.add y z))))
  | Some (Vec ((Open _ as n), _, _) | Vec (_, (Open _ as n), _) | Vec (_, _, n)) ->
    refuse "an argument that depends on it is a number" n
  | None -> None

let known = "a constant is expected"

let truth ?(why = known) report env e =
  Option.bind (Eval.cond (context ~why report) env e) (function Known b -> Some b | Depends _ -> None)

(* What is affine, and no function of the parameter that is asked about. *)
let affine_form report (at : Span.t) ~why = function
  | Form form -> Some form
  | Open n ->
    Not_linear.refuse report at ~why n;
    None

let in_states = "the states of the model would depend on it"

let number ?(why = known) report env (e : Ast.expr) =
  let*? n = Eval.num (context ~why report) env e in
  Option.bind (affine_form report e.at ~why n) Form.constant

let form report env (e : Ast.expr) =
  Option.bind (Eval.num (context report) env e) (affine_form report e.at ~why:in_states)

type odds = Known of Rat.t | Open of Open_number.t

let odds ~why report env (e : Ast.expr) =
  match Eval.num (context ~why report) env e with
  | Some (Open n) -> Some (Open n)
  | Some (Form form) -> Option.map (fun q -> Known q) (Form.constant form)
  | None -> None

let positive ?why report env what (e : Ast.expr) =
  match number ?why report env e with
  | Some q when Rat.sign q > 0 -> Some q
  | Some q ->
    Report.error report Code.bad_value e.at "the %s must be positive, and it is %s" what (Rat.to_string q);
    None
  | None -> None

let integer ?why report env what (e : Ast.expr) =
  match number ?why report env e with
  | Some q when Rat.is_integer q -> Some (Rat.floor q)
  | Some q ->
    Report.error report Code.bad_index e.at "%s must be an integer, and it is %s" what (Rat.to_string q);
    None
  | None -> None

let forms report ?why env (v : Ast.vector) =
  let form = affine_form report v.at ~why:(Option.value why ~default:in_states) in
  let*? x, y, z = Eval.vec (context ?why report) env v in
  match (form x, form y, form z) with Some x, Some y, Some z -> Some (x, y, z) | _ -> None

let vector ?(why = known) report env e = Option.bind (forms report ~why env e) Form.fixed
let place report env e = forms report env e

let check_determinant report at d =
  match Rat.sign d with
  | 1 -> true
  | 0 ->
    Report.error report Code.bad_transformation at "this transformation is singular: it flattens shapes";
    false
  | _ ->
    Report.error report Code.bad_transformation at
      "this transformation is a reflection: it would turn the faces of a shape inside out";
    false

let of_shapes = "the shapes of bodies must be known"

let corner report env v = vector ~why:of_shapes report env v

let scaling report env at v =
  match vector ~why:of_shapes report env v with
  | Some f when check_determinant report at (Rat.mul f.x (Rat.mul f.y f.z)) -> Some f
  | _ -> None

let turns = "what is turned so would not move as it does"

let rotation report env at (w, x, y, z) =
  let number = number ~why:turns report env in
  match (number w, number x, number y, number z) with
  | Some w, Some x, Some y, Some z -> (
      match Mat.of_quaternion (w, x, y, z) with
      | Some m -> Some (Placement.of_linear m)
      | None ->
        Report.error report Code.bad_transformation at "the zero quaternion is no rotation";
        None)
  | _ -> None

(* The 3 x 4 part and the last row of a matrix by rows. *)
let matrix report env at rows =
  let row (a, b, c, d) =
    let number = number ~why:"a matrix must be known; `translate` may depend on it" report env in
    match (number a, number b, number c, number d) with
    | Some a, Some b, Some c, Some d -> Some (Vec.make a b c, d)
    | _ -> None
  in
  match List.map row rows with
  | [ Some (r0, t0); Some (r1, t1); Some (r2, t2); Some (last, t3) ] ->
    if not (Vec.is_zero last && Rat.equal t3 Rat.one) then begin
      Report.error report Code.bad_transformation at
        "the last row of an affine map is (0, 0, 0, 1), and here it is (%s, %s, %s, %s)"
        (Rat.to_string last.x) (Rat.to_string last.y) (Rat.to_string last.z) (Rat.to_string t3);
      None
    end
    else
      let linear = Mat.make r0 r1 r2 in
      if check_determinant report at (Mat.det linear) then
        Some { Placement.linear; translation = Form.place (Vec.make t0 t1 t2) }
      else None
  | [ _; _; _; _ ] -> None
  | rows ->
    Report.error report Code.bad_arity at "a matrix has 4 rows, and this has %d" (List.length rows);
    None

let one_transform report env (t : Ast.transform) =
  match t.it with
  | Translate v -> Option.map Placement.translate (place report env v)
  | Rotate (w, x, y, z) -> rotation report env t.at (w, x, y, z)
  | Scale v -> Option.map (fun f -> Placement.of_linear (Mat.diagonal f)) (scaling report env t.at v)
  | Matrix rows -> matrix report env t.at rows

let transform report env ts =
  let compose whole t =
    match (whole, one_transform report env t) with
    | Some f, Some g -> Some (Placement.compose f g)
    | _ -> None
  in
  List.fold_left compose (Some Placement.identity) ts

let index report env e = integer ~why:"names must be known" report env "an index" e

let segment report env (s : Ast.segment) =
  match s.indices with
  | [] -> Some s.name.it
  | indices ->
    let*? known = Option.all (index report env) indices in
    Some (Printf.sprintf "%s[%s]" s.name.it (String.concat "," (List.map Z.to_string known)))
