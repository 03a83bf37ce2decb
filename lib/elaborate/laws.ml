open Scc_base
open Scc_exact
open Scc_syntax
open Scc_calculus

let variables : (string * Law.variable) list =
  [
    ("x", X);
    ("y", Y);
    ("z", Z);
    ("vx", Vx);
    ("vy", Vy);
    ("vz", Vz);
    ("mass", Mass);
    ("time", Time);
    ("dt", Dt);
  ]

let words = List.map fst variables

module Algebra = struct
  type context = { report : Report.t; budget : Typed.budget }
  type num = Law.expr
  type cond = Law.cond

  let report c = c.report
  let budget c = c.budget
  let const q = Law.Const q

  let constant = function
    | Law.Const q -> Some q
    | _ -> None

  let neg a = Law.Neg a
  let add a b = Law.Add (a, b)
  let sub a b = Law.Sub (a, b)
  let mul a b = Law.Mul (a, b)
  let div a b = Law.Div (a, b)
  let bool b = Law.Bool b

  let truth = function
    | Law.Bool b -> Some b
    | _ -> None

  let compare c a b = Law.Compare (c, a, b)
  let negate c = Law.Not c
  let conj a b = Law.And (a, b)
  let disj a b = Law.Or (a, b)
  let choose _ _ c a b = Some (Law.If (c, a, b))
  let choose_cond c a b = Law.Or (And (c, a), And (Not c, b))
  let nearest _ _ _ x = Some (Law.Round (x, Law.Const Rat.one))
  let admits _ _ _ _ _ = true

  let affine c at form =
    Not_linear.report c.report at ~why:"by laws of motion bodies do not move on straight lines" form;
    None

  let comparison _ _ _ _ _ = None

  let variable c env (path : Ast.path) =
    match path.it with
    | [ { name; indices = [] } ] -> (
        match List.assoc_opt name.it variables with
        | Some v -> Some (Typed.Num (Law.Var v))
        | None ->
          Report.error c.report Code.unknown_name path.at "unknown name `%s` in a law of motion" name.it
            ~near:(name.it, fun () -> List.map fst variables @ Env.names env);
          None)
    | _ ->
      Report.error c.report Code.type_mismatch path.at "this cannot stand in a law of motion"
        ~hint:"a law sees its own process alone: x, y, z, vx, vy, vz, mass, time and dt";
      None

  let round c at x (quantum : Law.expr) =
    match (x, quantum) with
    | _, Law.Const q when Rat.sign q <= 0 ->
      Report.error c.report Code.bad_law at "`round` to multiples of %s, which is not positive"
        (Rat.to_string q);
      None
    | Law.Const x, Law.Const q when Rat.bits x + Rat.bits q <= Limits.number_bits ->
      Some (Typed.Num (Law.Const (Rat.round_to x ~quantum:q)))
    | _ -> Some (Typed.Num (Law.Round (x, quantum)))

  let other c eval env (e : Ast.expr) =
    match e.it with
    | Apply ({ it = "round"; _ }, [ x; q ]) -> (
        match (eval env x, eval env q) with
        | Some (Typed.Num x), Some (Typed.Num q') -> round c q.at x q'
        | Some (Typed.Cond _ | Vec _), Some _ | Some _, Some (Typed.Cond _ | Vec _) ->
          Report.error c.report Code.type_mismatch e.at "`round` takes two numbers";
          None
        | None, _ | _, None -> None)
    | Apply ({ it = "round"; _ }, _) ->
      Report.error c.report Code.bad_arity e.at "`round` takes two arguments, a number and a quantum";
      None
    | Apply (f, _) when not (List.mem f.it Constant.of_state) ->
      Typed.unknown_function c.report f ("round" :: Typed.functions);
      None
    | _ ->
      Report.error c.report Code.type_mismatch e.at "this cannot stand in a law of motion"
        ~hint:"a law sees its own process alone: x, y, z, vx, vy, vz, mass, time and dt";
      None
end

module Eval = Typed.Make (Algebra)

let check report budget env e = ignore (Eval.eval { Algebra.report; budget } env e)

let can_read budget env e =
  let scratch = Report.create () in
  check scratch budget env e;
  not (Report.failed scratch)

(* [time] is a word of both. *)
let speaks_of_a_law env e =
  Limits.exists_in
    (fun (e : Ast.expr) ->
       match e.it with
       | Path { it = [ { name; indices = [] } ]; _ } ->
         List.mem_assoc name.it variables
         && (not (String.equal name.it "time"))
         && Option.is_none (Env.find env name.it)
       | _ -> false)
    e

let law report budget env (l : Ast.law) =
  match l.it with
  | Inertial -> Some Law.Inertial
  | Choose _ ->
    Report.error report Code.not_yet l.at "`choose` is not supported yet"
      ~hint:"this version executes `inertial` and laws given by expressions";
    None
  | Expression { it = Vector (x, y, z); _ } -> (
      let num = Eval.num { Algebra.report; budget } env in
      match (num x, num y, num z) with
      | Some x, Some y, Some z -> Some (Law.Velocity (x, y, z))
      | _ -> None)
  | Expression v ->
    Eval.vec { Algebra.report; budget } env v |> Option.map (fun (x, y, z) -> Law.Velocity (x, y, z))
