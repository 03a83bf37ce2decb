type colour = White | Black
type token = { sum : int; colour : colour }

type t = {
  first : bool;
  mutable balance : int;
  mutable mine : colour;
  mutable token : token option;
  mutable begun : bool;
}

type turn = Wait | Pass of token | Over

let make ~first = { first; balance = 0; mine = White; token = None; begun = false }
let sent t n = t.balance <- t.balance + n

let received t =
  t.balance <- t.balance - 1;
  t.mine <- Black

let arrived t token = t.token <- Some token

let round t =
  t.mine <- White;
  t.begun <- true;
  Pass { sum = 0; colour = White }

let idle t =
  match t.token with
  | None -> if t.first && not t.begun then round t else Wait
  | Some token ->
    t.token <- None;
    if not t.first then begin
      let colour = if t.mine = Black then Black else token.colour in
      t.mine <- White;
      Pass { sum = token.sum + t.balance; colour }
    end
    else if token.colour = White && t.mine = White && token.sum + t.balance = 0 then Over
    else round t
