open Scc_exact
open Svg_number

type box = { x : Rat.t; y : Rat.t; width : Rat.t; height : Rat.t }

let box text =
  match all text with
  | [ x; y; width; height ] ->
    if Rat.sign width < 0 || Rat.sign height < 0 then raise (Bad "a viewBox with a negative side");
    { x; y; width; height }
  | _ -> raise (Bad "a viewBox without four numbers")

let words text = List.filter (( <> ) "") (String.split_on_char ' ' (String.map (fun c -> if is_blank c then ' '
                                                                                 else c) text))

let fault text = raise (Bad (Printf.sprintf "the preserveAspectRatio %S" text))

(* How much of the room that is left comes before the box. *)
let share text = function "Min" -> Rat.zero | "Mid" -> Rat.half | "Max" -> Rat.one | _ -> fault text

type ratio = Stretched | Even of { left : Rat.t; top : Rat.t; slice : bool }

let ratio text =
  let even align ~slice =
    if String.length align <> 8 || align.[0] <> 'x' || align.[4] <> 'Y' then fault text;
    Even { left = share text (String.sub align 1 3); top = share text (String.sub align 5 3); slice }
  in
  (* [defer] is for pictures alone. *)
  match (match words text with "defer" :: (_ :: _ as rest) -> rest | words -> words) with
  | [] -> even "xMidYMid" ~slice:false
  | "none" :: ([] | [ ("meet" | "slice") ]) -> Stretched
  | [ align ] | [ align; "meet" ] -> even align ~slice:false
  | [ align; "slice" ] -> even align ~slice:true
  | _ -> fault text

let check text = ignore (ratio text)

let fit text ~inside box =
  let across = Rat.div inside.width box.width and down = Rat.div inside.height box.height in
  let placed sx sy left top =
    let shift at room side scale before = Rat.add at (Rat.mul before (Rat.sub room (Rat.mul side scale))) in
    let x = shift inside.x inside.width box.width sx left and y = shift inside.y inside.height box.height sy top in
    Plane_map.(compose (translation x y) (compose (scaling sx sy) (translation (Rat.neg box.x) (Rat.neg box.y))))
  in
  match ratio (Option.value text ~default:"") with
  | Stretched -> placed across down Rat.zero Rat.zero
  | Even { left; top; slice } ->
    let s = if slice then Rat.max across down else Rat.min across down in
    placed s s left top

let unfit text ~inside box =
  let { Plane_map.a; d; e; f; _ } = fit text ~inside box in
  {
    x = Rat.div (Rat.sub inside.x e) a; y = Rat.div (Rat.sub inside.y f) d; width = Rat.div inside.width a;
    height = Rat.div inside.height d;
  }
