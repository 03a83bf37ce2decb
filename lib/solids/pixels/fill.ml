type rule = Nonzero | Even_odd

let unit = Svg_polygon.unit
let ceil_div a b = if a >= 0 then (a + b - 1) / b else -(-a / b)

(* The first row or column whose centre is not before a place. *)
let next place = ceil_div (place - (unit / 2)) unit

(* The columns and rows of the picture, each from the first on and before the last, whose centres may be inside. *)
let range ~width ~height polygons =
  let corner (x0, y0, x1, y1) (x, y) = Int.(min x0 x, min y0 y, max x1 x, max y1 y) in
  let x0, y0, x1, y1 =
    List.fold_left (List.fold_left corner) (max_int / 2, max_int / 2, -(max_int / 2), -(max_int / 2)) polygons
  in
  if x0 > x1 then (0, 0, 0, 0) else (max 0 (next x0), max 0 (next y0), min width (next x1), min height (next y1))

let cost ~width ~height polygons =
  let left, top, right, bottom = range ~width ~height polygons in
  max 0 (right - left) * max 0 (bottom - top)

(* Of each row the changes of the winding number, by the first column whose centre is not left of the crossing. *)
let inside ~width ~height rule polygons f =
  let left, top, right, bottom = range ~width ~height polygons in
  let columns = right - left in
  if columns > 0 && bottom > top then begin
    let changes = Array.make ((columns + 1) * (bottom - top)) 0 in
    let edge (x0, y0) (x1, y1) =
      if y0 <> y1 then begin
        let step, (xa, ya), (xb, yb) = if y0 < y1 then (1, (x0, y0), (x1, y1)) else (-1, (x1, y1), (x0, y0)) in
        for row = max top (next ya) to min bottom (next yb) - 1 do
          let y = (row * unit) + (unit / 2) in
          (* The least column with unit * column + unit / 2 >= x, where x = xa + (xb - xa) (y - ya) / (yb - ya). *)
          let d = yb - ya in
          let numerator = ((xa - (unit / 2)) * d) + ((xb - xa) * (y - ya)) in
          let column = max left (min right (ceil_div numerator (unit * d))) in
          let k = ((row - top) * (columns + 1)) + column - left in
          changes.(k) <- changes.(k) + step
        done
      end
    in
    let polygon = function
      | [] -> ()
      | first :: _ as corners ->
        let rec go = function
          | a :: (b :: _ as rest) -> edge a b; go rest
          | [ last ] -> edge last first
          | [] -> ()
        in
        go corners
    in
    List.iter polygon polygons;
    for row = top to bottom - 1 do
      let winding = ref 0 in
      for column = left to right - 1 do
        winding := !winding + changes.(((row - top) * (columns + 1)) + column - left);
        let inside = match rule with Nonzero -> !winding <> 0 | Even_odd -> !winding land 1 <> 0 in
        if inside then f ((row * width) + column)
      done
    done
  end
