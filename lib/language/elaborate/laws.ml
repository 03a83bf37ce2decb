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
    ("wx", Wx);
    ("wy", Wy);
    ("wz", Wz);
    ("mass", Mass);
    ("time", Time);
    ("dt", Dt);
  ]

let words = List.map fst variables
let diffuse = "diffuse"
let functions = [ diffuse ]

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

  let open_number _ _ n = Some (Law.Open n)
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
    Not_linear.report c.report at ~why:"the velocities and weights of a law of motion are numbers" form;
    None

  let comparison _ _ _ _ _ = None

  let variable c env (path : Ast.path) =
    match path.it with
    | [ { name; indices = [] } ] -> (
        match List.assoc_opt name.it variables with
        | Some v -> Some (Typed.Num (Law.Var v))
        | None ->
          Report.error c.report Code.unknown_name path.at "unknown name `%s` in a law of motion" name.it
            ?hint:(Typed.without_brackets (("round" :: functions) @ Typed.functions) name.it)
            ~near:(name.it, fun () -> List.map fst variables @ Env.names env);
          None)
    | _ ->
      Report.error c.report Code.type_mismatch path.at "this cannot stand in a law of motion"
        ~hint:"a law sees its own process alone: x, y, z, vx, vy, vz, wx, wy, wz, mass, time and dt";
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
    | Apply ({ it; at }, _) when String.equal it diffuse ->
      Report.error c.report Code.type_mismatch at "`diffuse` is a whole law, and cannot stand within one"
        ~hint:"its second argument is a drift, as in `diffuse(1, (vx, vy, vz)/2)`";
      None
    | Apply (f, _) when not (List.mem f.it Constant.of_state) ->
      Typed.unknown_function c.report f (("round" :: functions) @ Typed.functions);
      None
    | _ ->
      Report.error c.report Code.type_mismatch e.at "this cannot stand in a law of motion"
        ~hint:"a law sees its own process alone: x, y, z, vx, vy, vz, wx, wy, wz, mass, time and dt";
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

(* The first number in a term that depends on a parameter. *)
let rec open_in : Law.expr -> Open_number.t option = function
  | Open n -> Some n
  | Const _ | Var _ -> None
  | Neg a -> open_in a
  | Add (a, b) | Sub (a, b) | Mul (a, b) | Div (a, b) | Round (a, b) -> either a b
  | If (c, a, b) -> ( match open_in_cond c with Some n -> Some n | None -> either a b)

and either a b = match open_in a with Some n -> Some n | None -> open_in b

and open_in_cond : Law.cond -> Open_number.t option = function
  | Bool _ -> None
  | Compare (_, a, b) -> either a b
  | And (a, b) | Or (a, b) -> ( match open_in_cond a with Some n -> Some n | None -> open_in_cond b)
  | Not c -> open_in_cond c

let refused c at ~why e =
  match open_in e with
  | None -> false
  | Some n ->
    Not_linear.refuse c.Algebra.report at ~why n;
    true

let any_vector c env (v : Ast.expr) =
  match v.it with
  | Vector (x, y, z) -> (
      match (Eval.num c env x, Eval.num c env y, Eval.num c env z) with
      | Some x, Some y, Some z -> Some (x, y, z)
      | _ -> None)
  | _ -> Eval.vec c env v

let vector c env (v : Ast.expr) =
  let*? x, y, z = any_vector c env v in
  let why = "bodies would move otherwise, and the states of the model would not be the same" in
  if List.exists (refused c v.at ~why) [ x; y; z ] then None else Some (x, y, z)

(* A weight that depends on the parameter alone has one sign, so that the graph is the same for all its values. *)
let check_open c (e : Ast.expr) weight =
  let report = c.Algebra.report in
  match open_in weight with
  | None -> true
  | Some n when Law.misused weight ->
    Not_linear.refuse report e.at ~why:"what is compared or rounded must be known" n;
    false
  | Some _ when Law.is_constant (Gives (Law.velocity_alone (weight, weight, weight))) |> not -> true
  | Some { parameter; _ } -> (
      let pole = ref None in
      let divisor f =
        let zero = Rational_function.(equal f zero) in
        if not zero then pole := Open_number.vanishing parameter f;
        (not zero) && Option.is_none !pole
      in
      match (Law.form ~divisor (fun _ -> Rat.zero) weight, Law.eval (fun _ -> Rat.zero) weight) with
      | Ok f, Ok value -> Release.has_one_sign report e.at "a weight" parameter f value
      | Error _, _ | _, Error _ ->
        (match !pole with
         | Some x ->
           Report.error report Code.division_by_zero e.at "a division by zero for %s" (Open_number.at parameter x)
             ~hint:(Open_number.narrower parameter)
         | None ->
           Report.error report Code.division_by_zero e.at "a division by zero, whatever `%s` is" parameter.name);
        false)

(* What is known now of a weight; the rest is seen when it is drawn by. *)
let weight c env (e : Ast.expr option) =
  match e with
  | None -> Some (Law.Const Rat.one)
  | Some e -> (
      match Eval.num c env e with
      | Some (Law.Const w) when Rat.sign w < 0 ->
        Report.error c.Algebra.report Code.bad_law e.at "a weight of %s, which is negative" (Rat.to_string w);
        None
      | Some weight -> if check_open c e weight then Some weight else None
      | None -> None)

let motion c env velocity spin =
  let spin = Option.fold ~none:(Some None) ~some:(fun w -> Option.map Option.some (vector c env w)) spin in
  match (vector c env velocity, spin) with
  | Some velocity, Some spin -> Some { Law.velocity; spin }
  | _ -> None

let kick c env (k : Ast.kick) =
  let one env =
    match (motion c env k.velocity k.spin, weight c env k.weight) with
    | Some motion, Some weight -> Some { Law.motion; weight }
    | _ -> None
  in
  Option.bind (Indices.scopes c.Algebra.report env k.over) (Option.all one)

let is_nothing (k : Law.kick) = match k.weight with Const w -> Rat.sign w = 0 | _ -> false

(* {1 Diffusion} *)

let known c at (e : Law.expr) =
  match e with
  | Const q -> Some q
  | e when refused c at ~why:"the kicks of `diffuse` would depend on it" e -> None
  | _ ->
    Report.error c.Algebra.report Code.bad_law at
      "`diffuse` takes known numbers: what depends on the state is drift";
    None

let not_negative c at q =
  if Rat.sign q >= 0 then Some q
  else begin
    Report.error c.Algebra.report Code.bad_law at "a diffusion constant of %s, which is negative"
      (Rat.to_string q);
    None
  end

(* One for all directions, or one for each axis. *)
let constants c env (e : Ast.expr) =
  let constant x = Option.bind (known c e.at x) (not_negative c e.at) in
  match Eval.eval c env e with
  | Some (Typed.Num d) -> Option.map (fun d -> Vec.make d d d) (constant d)
  | Some (Typed.Vec (x, y, z)) -> (
      match (constant x, constant y, constant z) with
      | Some x, Some y, Some z -> Some (Vec.make x y z)
      | _ -> None)
  | Some (Typed.Cond _) ->
    Report.error c.report Code.type_mismatch e.at "a diffusion constant is a number, or a vector of three";
    None
  | None -> None

let length c env (e : Ast.expr) =
  match Option.bind (Eval.num c env e) (known c e.at) with
  | Some h when Rat.sign h <= 0 ->
    Report.error c.Algebra.report Code.bad_law e.at "a kick of %s, which is not positive" (Rat.to_string h);
    None
  | h -> h

let kick_name = "h"
let turning_name = "turning"

(* The arguments by their places, and those at the end that have a name. *)
let by_name (args : Ast.expr list) =
  let rec from_the_last named : Ast.expr list -> _ = function
    | { it = Binary (Eq, { it = Path { it = [ { name = { it; _ }; indices = [] } ]; _ }; _ }, e); _ } :: before
      when List.mem it [ kick_name; turning_name ] && not (List.mem_assoc it named) ->
      from_the_last ((it, e) :: named) before
    | rest -> (List.rev rest, fun name -> List.assoc_opt name named)
  in
  from_the_last [] (List.rev args)

let with_turns c ~timestep at kicks = function
  | None -> Some (kicks, None)
  | Some constants -> (
      match Diffusion.turns ~timestep constants with
      | Ok (spin, spins) -> Some (Diffusion.spun kicks spins, Some spin)
      | Error most ->
        Report.error c.Algebra.report Code.bad_law at
          "no turn of one timestep is enough to diffuse in orientation so fast: the constants of `%s` sum to more \
           than %s"
          turning_name (Rat.to_string most) ~hint:"a shorter timestep allows more";
        None)

let diffuses c ~timestep at ~drift ~kick ~turning d =
  let spread = Diffusion.spread ~timestep d in
  let chosen = Option.is_none kick in
  let kick = match kick with Some h -> h | None -> Diffusion.least_kick ~timestep d in
  match Diffusion.kicks ~timestep ~drift ~kick d with
  | Ok kicks ->
    let choice (kicks, spin) = (Law.Choose kicks, Some { Diffusion.kick; spread; chosen; spin }) in
    Option.map choice (with_turns c ~timestep at kicks turning)
  | Error least ->
    Report.error c.Algebra.report Code.bad_law at
      "kicks of %s are too short to diffuse so fast: their square is less than %s, which is 2 d times the \
       timestep, of all axes together"
      (Rat.to_string kick) (Rat.to_string least);
    None

let diffusion c ~timestep env at args =
  let at_rest = Law.(Const Rat.zero, Const Rat.zero, Const Rat.zero) in
  let if_given read e = Option.fold ~none:(Some None) ~some:(fun e -> Option.map Option.some (read c env e)) e in
  let args, named = by_name args in
  let read d drift h =
    let drift = Option.fold ~none:(Some at_rest) ~some:(vector c env) drift in
    match (constants c env d, drift, if_given length h, if_given constants (named turning_name)) with
    | Some d, Some drift, Some kick, Some turning -> diffuses c ~timestep at ~drift ~kick ~turning d
    | _ -> None
  in
  match (args, named kick_name) with
  | [ d ], h -> read d None h
  | [ d; v ], h -> read d (Some v) h
  | [ d; v; h ], None -> read d (Some v) (Some h)
  | _ ->
    Report.error c.report Code.bad_arity at
      "`diffuse` takes a diffusion constant, and then a drift and the length of a kick, if they are to be said"
      ~hint:"`diffuse(1, h = 2)` gives the length without a drift, and `diffuse(1, turning = 1/4)` turns as well";
    None

let no_spin c (spin : Ast.vector) =
  Report.error c.Algebra.report Code.type_mismatch spin.at "`diffuse` is a whole law, and takes no spin beside it"
    ~hint:"`diffuse(1/8, turning = 1/4)` diffuses in orientation as well"

let law report budget ~timestep env (l : Ast.law) =
  let c = { Algebra.report; budget } in
  let plain law = (law, None) in
  match l.it with
  | Inertial -> Some (plain Law.Inertial)
  | Expression ({ it = Apply ({ it = f; _ }, args); at }, spin) when String.equal f diffuse ->
    Option.iter (no_spin c) spin;
    diffusion c ~timestep env at args
  | Expression (v, spin) -> Option.map (fun m -> plain (Law.Gives m)) (motion c env v spin)
  | Choose kicks -> (
      match Option.all (kick c env) kicks with
      | None -> None
      | Some kicks ->
        let kicks = List.concat kicks in
        if not (List.for_all is_nothing kicks) then Some (plain (Law.Choose kicks))
        else begin
          Report.error report Code.bad_law l.at
            "the weights of all velocities are 0, or there is none: there is nothing to choose";
          None
        end)

let some_diffuse =
  let is_so (i : Ast.item) =
    match i.it with
    | Motion (_, { it = Expression ({ it = Apply ({ it; _ }, _); _ }, _); _ }) -> String.equal it diffuse
    | _ -> false
  in
  let rec some items = List.exists (fun (i : Ast.item) -> is_so i || some (inner i)) items
  and inner (i : Ast.item) = match i.it with For (_, items) -> items | _ -> [] in
  some
