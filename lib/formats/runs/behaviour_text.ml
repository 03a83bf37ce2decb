open Scc_exact
open Scc_calculus

let site m leaf s =
  let whole = Model.site_name m ~leaf s in
  let prefix = m.Model.leaves.(leaf).name ^ "." in
  let k = String.length prefix in
  if String.length whole > k && String.equal (String.sub whole 0 k) prefix then
    String.sub whole k (String.length whole - k)
  else whole

let surface m leaf (c : Behaviour.channel) =
  let only s = "only " ^ site m leaf s in
  "{" ^ String.concat ", " (List.map (site m leaf) c.sites @ List.map only c.only) ^ "}"

let bare m leaf (c : Behaviour.channel) = Printf.sprintf "%s, %s" c.name (surface m leaf c)

let push j = if Rat.sign j = 0 then "" else Printf.sprintf " push(%s)" (Rat.to_string j)

let odds = function None -> "" | Some odds -> " " ^ Odds.to_string odds

let prefix m leaf : Behaviour.t -> string option = function
  | Open (polarity, c, _) ->
    let bar = match polarity with Name -> "" | Co_name -> "~" in
    Some (Printf.sprintf "<%s%s>. " bar (bare m leaf c))
  | Weak (c, j, _) -> Some (Printf.sprintf "omega(%s)%s%s. " (bare m leaf c) (push j.push) (odds j.odds))
  | Strong (cs, j, _) ->
    let entry c = "<" ^ bare m leaf c ^ ">" in
    Some (Printf.sprintf "rho({%s})%s. " (String.concat ", " (List.map entry cs)) (push j))
  | Delay (t, _) -> Some (Printf.sprintf "eps(%s). " (Rat.to_string t))
  | Wait (t, _) ->
    let name i = m.Model.ranges.(i).name in
    Some (Printf.sprintf "eps(%s). " (Scc_polyhedra.Text.form ~name t))
  | Nil | Sum _ | Call _ -> None

(* Where a term stands decides whether a sum needs brackets. *)
type place = Top | Right_of_sum | After_prefix

type work = Text of string | Term of place * Behaviour.t

(* Terms may be deep, so what is left to write is a list and not the call stack. *)
let to_string (m : Model.t) ~leaf term =
  let b = Buffer.create 64 in
  let rec write = function
    | [] -> Buffer.contents b
    | Text s :: rest ->
      Buffer.add_string b s;
      write rest
    | Term (place, t) :: rest -> write (unfold place t rest)
  and unfold place (t : Behaviour.t) rest =
    match t with
    | Nil -> Text "nil" :: rest
    | Call k -> Text m.definitions.(k).name :: rest
    | Sum (l, r) -> (
        let sum rest = Term (Top, l) :: Text " + " :: Term (Right_of_sum, r) :: rest in
        match place with
        | Top -> sum rest
        | Right_of_sum | After_prefix -> Text "(" :: sum (Text ")" :: rest))
    | Open (_, _, next) | Weak (_, _, next) | Strong (_, _, next) | Delay (_, next) | Wait (_, next) -> (
        match prefix m leaf t with
        | Some p -> Text p :: Term (After_prefix, next) :: rest
        | None -> Scc_base.Bug.fail __POS__ "a prefix without its text")
  in
  write [ Term (Top, term) ]
