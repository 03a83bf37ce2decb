open Scc_exact
open Scc_calculus

type 'c t = {
  one : 'c;
  value : 'c -> Rat.t;
  add : 'c -> 'c -> 'c;
  sub : 'c -> 'c -> 'c;
  mul : 'c -> 'c -> 'c;
  div : 'c -> 'c -> 'c;
  weight : (Law.variable -> Rat.t) -> Law.expr -> ('c, Law.fault) result;
  shares : step:Rat.t -> Odds.t list -> 'c list;
  laws :
    Kinematics.setting -> int -> Law.t ->
    (unit -> ((Given.t * 'c) list, Law.fault) result) ->
    ((Given.t * 'c) list, Law.fault) result;
}

let rationals =
  {
    one = Rat.one;
    value = Fun.id;
    add = Rat.add;
    sub = Rat.sub;
    mul = Rat.mul;
    div = Rat.div;
    weight = Law.eval;
    shares = Odds.shares;
    laws = (fun c -> c.laws);
  }

type open_ = Rat.t * Rational_function.t

let open_numbers range =
  let both f g (x, a) (y, b) = (f x y, g a b) in
  let weight env e =
    let* value = Law.eval env e in
    let divisor f =
      (not Rational_function.(equal f zero)) && Option.is_none (Open_number.vanishing range f)
    in
    Result.map (fun form -> (value, form)) (Law.form ~divisor env e)
  in
  let shares ~step odds = List.combine (Odds.shares ~step odds) (Odds.forms ~step odds) in
  {
    one = (Rat.one, Rational_function.one);
    value = fst;
    add = both Rat.add Rational_function.add;
    sub = both Rat.sub Rational_function.sub;
    mul = both Rat.mul Rational_function.mul;
    div = both Rat.div Rational_function.div;
    weight;
    shares;
    laws = (fun _ _ _ ask -> ask ());
  }
