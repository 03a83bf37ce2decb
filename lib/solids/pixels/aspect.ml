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

(* How much of the room that is left comes before the box. *)
let share text = function
  | "Min" -> Rat.zero
  | "Mid" -> Rat.half
  | "Max" -> Rat.one
  | _ -> raise (Bad (Printf.sprintf "the preserveAspectRatio %S" text))

let fit ratio ~inside box =
  let text = Option.value ratio ~default:"" in
  let fault () = raise (Bad (Printf.sprintf "the preserveAspectRatio %S" text)) in
  let across = Rat.div inside.width box.width and down = Rat.div inside.height box.height in
  let placed sx sy left top =
    let shift at room side scale before = Rat.add at (Rat.mul before (Rat.sub room (Rat.mul side scale))) in
    let x = shift inside.x inside.width box.width sx left and y = shift inside.y inside.height box.height sy top in
    Plane_map.(compose (translation x y) (compose (scaling sx sy) (translation (Rat.neg box.x) (Rat.neg box.y))))
  in
  let aligned align choose =
    if String.length align <> 8 || align.[0] <> 'x' || align.[4] <> 'Y' then fault ();
    let s = choose across down in
    placed s s (share text (String.sub align 1 3)) (share text (String.sub align 5 3))
  in
  match words text with
  | [] -> aligned "xMidYMid" Rat.min
  | "none" :: ([] | [ ("meet" | "slice") ]) -> placed across down Rat.zero Rat.zero
  | [ align ] | [ align; "meet" ] -> aligned align Rat.min
  | [ align; "slice" ] -> aligned align Rat.max
  | _ -> fault ()
