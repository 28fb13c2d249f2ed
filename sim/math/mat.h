// Small dense matrices of a fixed size over any scalar (double or Lanes), held by value.
#pragma once

namespace sim {

template <class T, int Rows, int Cols>
struct Mat {
  T a[Rows][Cols];

  T& operator()(int i, int j) { return a[i][j]; }
  const T& operator()(int i, int j) const { return a[i][j]; }

  static Mat zero() {
    Mat m;
    for (int i = 0; i < Rows; ++i)
      for (int j = 0; j < Cols; ++j) m(i, j) = T(0);
    return m;
  }
  static Mat identity() {
    Mat m = zero();
    for (int i = 0; i < (Rows < Cols ? Rows : Cols); ++i) m(i, i) = T(1);
    return m;
  }
};

template <class T, int R, int C>
Mat<T, C, R> transpose(const Mat<T, R, C>& A) {
  Mat<T, C, R> B;
  for (int i = 0; i < R; ++i)
    for (int j = 0; j < C; ++j) B(j, i) = A(i, j);
  return B;
}

template <class T, int R, int K, int C>
Mat<T, R, C> operator*(const Mat<T, R, K>& A, const Mat<T, K, C>& B) {
  Mat<T, R, C> AB;
  for (int i = 0; i < R; ++i)
    for (int j = 0; j < C; ++j) {
      T sum = A(i, 0) * B(0, j);
      for (int k = 1; k < K; ++k) sum += A(i, k) * B(k, j);
      AB(i, j) = sum;
    }
  return AB;
}

// A B^T, without forming the transpose.
template <class T, int R, int K, int C>
Mat<T, R, C> times_transpose(const Mat<T, R, K>& A, const Mat<T, C, K>& B) {
  Mat<T, R, C> ABt;
  for (int i = 0; i < R; ++i)
    for (int j = 0; j < C; ++j) {
      T sum = A(i, 0) * B(j, 0);
      for (int k = 1; k < K; ++k) sum += A(i, k) * B(j, k);
      ABt(i, j) = sum;
    }
  return ABt;
}

// A^T B, without forming the transpose.
template <class T, int R, int K, int C>
Mat<T, R, C> transpose_times(const Mat<T, K, R>& A, const Mat<T, K, C>& B) {
  Mat<T, R, C> AtB;
  for (int i = 0; i < R; ++i)
    for (int j = 0; j < C; ++j) {
      T sum = A(0, i) * B(0, j);
      for (int k = 1; k < K; ++k) sum += A(k, i) * B(k, j);
      AtB(i, j) = sum;
    }
  return AtB;
}

template <class T, int R, int C>
Mat<T, R, C> operator+(const Mat<T, R, C>& A, const Mat<T, R, C>& B) {
  Mat<T, R, C> S;
  for (int i = 0; i < R; ++i)
    for (int j = 0; j < C; ++j) S(i, j) = A(i, j) + B(i, j);
  return S;
}

template <class T, int R, int C>
Mat<T, R, C> operator-(const Mat<T, R, C>& A, const Mat<T, R, C>& B) {
  Mat<T, R, C> S;
  for (int i = 0; i < R; ++i)
    for (int j = 0; j < C; ++j) S(i, j) = A(i, j) - B(i, j);
  return S;
}

template <class T, int R, int C>
Mat<T, R, C> operator*(const T& s, const Mat<T, R, C>& A) {
  Mat<T, R, C> B;
  for (int i = 0; i < R; ++i)
    for (int j = 0; j < C; ++j) B(i, j) = s * A(i, j);
  return B;
}

// A : B, the sum of the products of the entries.
template <class T, int R, int C>
T contract(const Mat<T, R, C>& A, const Mat<T, R, C>& B) {
  T sum = A(0, 0) * B(0, 0);
  for (int i = 0; i < R; ++i)
    for (int j = (i == 0 ? 1 : 0); j < C; ++j) sum += A(i, j) * B(i, j);
  return sum;
}

template <class T, int N>
T trace(const Mat<T, N, N>& A) {
  T sum = A(0, 0);
  for (int i = 1; i < N; ++i) sum += A(i, i);
  return sum;
}

// det F and its derivative dJ/dF, the cofactor matrix J F^{-T}.
template <class T>
T determinant(const Mat<T, 2, 2>& F) {
  return F(0, 0) * F(1, 1) - F(0, 1) * F(1, 0);
}
template <class T>
Mat<T, 2, 2> cofactor(const Mat<T, 2, 2>& F) {
  return {{{F(1, 1), -F(1, 0)}, {-F(0, 1), F(0, 0)}}};
}
template <class T>
Mat<T, 3, 3> cofactor(const Mat<T, 3, 3>& F) {
  Mat<T, 3, 3> A;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      A(i, j) = F(i1, j1) * F(i2, j2) - F(i1, j2) * F(i2, j1);
    }
  return A;
}
template <class T>
T determinant(const Mat<T, 3, 3>& F) {
  const Mat<T, 3, 3> A = cofactor(F);
  return F(0, 0) * A(0, 0) + F(0, 1) * A(0, 1) + F(0, 2) * A(0, 2);
}

}  // namespace sim
