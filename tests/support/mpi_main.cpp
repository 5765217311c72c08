// SPDX-License-Identifier: MIT
// GoogleTest across ranks: every rank runs every test; rank 0 prints, other ranks print their failures only, and the
// exit code is that of the worst rank. In tests on several ranks use EXPECT_*: a lone ASSERT_* that leaves a
// collective would hang the others.
#include <gtest/gtest.h>
#include <iostream>
#include <mpi.h>

namespace {

class FailurePrinter : public testing::EmptyTestEventListener {
public:
    explicit FailurePrinter(int rank) : rank_(rank) {}

private:
    void OnTestPartResult(const testing::TestPartResult& result) override
    {
        if (!result.failed()) return;
        const char* file = result.file_name() ? result.file_name() : "unknown file";
        std::cerr << "[rank " << rank_ << "] " << file << ":" << result.line_number() << ": " << result.summary() << std::endl;
    }
    int rank_;
};

}  // namespace

int main(int argc, char** argv)
{
    int provided = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    testing::InitGoogleTest(&argc, argv);
    if (rank != 0) {
        auto& listeners = testing::UnitTest::GetInstance()->listeners();
        delete listeners.Release(listeners.default_result_printer());
        listeners.Append(new FailurePrinter(rank));
    }
    const int mine = RUN_ALL_TESTS();
    int worst = 0;
    MPI_Allreduce(&mine, &worst, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    MPI_Finalize();
    return worst;
}
