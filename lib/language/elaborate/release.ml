open Scc_base
open Scc_exact
open Scc_syntax
open Scc_calculus

let of_pushes = "velocities would depend on it, and times at which bodies meet not be linear"

let push report env = function
  | None -> Some Rat.zero
  | Some (e : Ast.expr) -> (
      match Constant.number ~why:of_pushes report env e with
      | Some q when Rat.sign q < 0 ->
        Report.error report Code.bad_value e.at "a push is not negative, and this is %s" (Rat.to_string q)
          ~hint:"what is split can be pushed apart, and not pulled into each other";
        None
      | q -> q)

let of_chances = "probabilities would depend on it"

let chance report (e : Ast.expr) q =
  if Rat.sign q >= 0 && Rat.compare q Rat.one <= 0 then Some (Odds.Chance q)
  else begin
    Report.error report Code.bad_value e.at "a chance is a probability, between 0 and 1, and this is %s"
      (Rat.to_string q)
      ~hint:"it is that of being released at one split instant; for so many times a unit of time say `rate`";
    None
  end

let has_one_sign report at what (parameter : Ranges.range) f value =
  match Open_number.vanishing parameter f with
  | Some x ->
    Report.error report Code.bad_value at
      "%s is 0 for %s, or not defined, and transitions would come and go there" what (Open_number.at parameter x)
      ~hint:(Open_number.narrower parameter);
    false
  | None when Rat.sign value < 0 ->
    Report.error report Code.bad_value at "%s is negative for all `%s`" what (Ranges.range_to_string parameter);
    false
  | None -> true

(* It may be 0, or 1, for all values, and for none of them alone. *)
let open_chance report (e : Ast.expr) (n : Open_number.t) =
  let sure = Rational_function.(sub one n.form) in
  match Rational_function.to_constant n.form with
  | Some q -> chance report e q
  | None ->
    if
      has_one_sign report e.at "a chance" n.parameter n.form n.value
      && has_one_sign report e.at "1 minus a chance" n.parameter sure (Rat.sub Rat.one n.value)
    then Some (Odds.Open_chance n)
    else None

let rate report ~step (e : Ast.expr) r =
  if Rat.sign r < 0 then begin
    Report.error report Code.bad_value e.at "a rate is not negative, and this is %s" (Rat.to_string r)
      ~hint:"it tells how often per unit of time";
    None
  end
  else if Rat.compare (Rat.mul r step) (Rat.of_int Odds.greatest) > 0 then begin
    Report.error report Code.bad_value e.at "a rate of %s is too great for the split step %s" (Rat.to_string r)
      (Rat.to_string step)
      ~hint:(Printf.sprintf "their product may be %d at most: give a shorter `split_step`" Odds.greatest);
    None
  end
  else Some (Odds.Rate { rate = r; alone = Odds.within ~step r })

let known report ~step env ({ odds; value } : Ast.odds) =
  match odds.it with
  | "chance" -> (
      match Constant.odds ~why:of_chances report env value with
      | Some (Known q) -> chance report value q
      | Some (Open n) -> open_chance report value n
      | None -> None)
  | "rate" ->
    let why = "the chance of a rate is the simplest fraction near its exponential, and no function of the rate" in
    Option.bind (Constant.number ~why report env value) (rate report ~step value)
  | word ->
    Report.error report Code.syntax odds.at "expected `chance` or `rate`, and this is `%s`" word
      ~hint:"as in `omega(a, {top}) chance 1/10. B`";
    None

let odds report ~(splits : Model.splits) env (odds : Ast.odds option) =
  match (odds, splits) with
  | None, _ -> Some None
  | Some odds, Every step -> Option.map Option.some (known report ~step env odds)
  | Some { odds; _ }, Any_time ->
    Report.error report Code.chance_at_any_time odds.at
      "with `split_step any` there are no instants at which to draw"
      ~hint:"give a `split_step`: chances are drawn at its multiples";
    None
