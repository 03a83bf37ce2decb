include Hashtbl.Make (struct
    type t = int * int

    let equal (a, b) (c, d) = Int.equal a c && Int.equal b d
    let hash (a, b) = ((a * 0x9E3779B1) + b) land max_int
  end)
